// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "pathtracer/light_tree.h"
#include "scenes/world.h"

namespace plumbline::pathtracer {

/// Where the light of `light` comes from. Exact for a point; a spot's cone is widened by what
/// rounding may do to its edge.
LightBounds light_bounds(const PointLight& light);

/// Chooses one of a world's point, sphere and spot lights for each surface point, by a LightTree
/// nine times in ten, evenly otherwise.
///
/// A vertex then costs one shadow ray however many lights there are, and the noise of the choice:
/// the tree knows how far lights are and where they and the surface face, not what hides them.
class LightChoice {
 public:
    /// `world` must outlive it. Without a light that is not dark, none is ever chosen.
    explicit LightChoice(const World& world);

    struct Choice {
        const PointLight* light;
        float probability;  ///< above 0
    };
    /// A light for the point `x` with unit normal `n` by a number `u` of [0,1); none if none can
    /// reach that side of the surface.
    std::optional<Choice> choose(const glm::vec3& x, const glm::vec3& n, float u) const;

 private:
    std::vector<const PointLight*> lights_;  ///< those that are not dark
    LightTree tree_;
};

}  // namespace plumbline::pathtracer
