// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scenes/world.h"

namespace plumbline::ddgi {

/// What changed from one frame to the next.
struct Motion {
    /// Of every object that moved: where it was and where it is, grown by the rounding of rays.
    std::vector<Bounds> boxes;
    std::vector<bool> moved;  ///< one an object of the world
    bool lights = false;      ///< a light changed

    bool none() const { return boxes.empty() && !lights; }
};

/// What moved alone, where it is now.
World moved_part(const World& world, const Motion& motion);

/// Compares two frames of one scene.
Motion motion_between(const World& before, const World& after);

/// Whether the points origin + t direction with 0 <= t <= length meet the box; `length` may be
/// infinite.
bool meets(const Bounds& box, const glm::vec3& origin, const glm::vec3& direction, float length);

}  // namespace plumbline::ddgi
