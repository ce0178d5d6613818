// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenes/scene.h"

namespace plumbline {

/// Turns positions on the picture to rays.
class CameraRays {
 public:
    explicit CameraRays(const Camera& camera);

    /// The ray through (x, y) in pixels from the top left corner; pixel (i, j) covers
    /// [i, i+1) x [j, j+1).
    Ray through(float x, float y) const {
        return {eye_, glm::normalize(corner_ + right_ * x + down_ * y)};
    }

 private:
    glm::vec3 eye_;
    glm::vec3 corner_;  ///< direction through the top left corner, not normalised
    glm::vec3 right_;   ///< one pixel to the right
    glm::vec3 down_;    ///< one pixel down
};

}  // namespace plumbline
