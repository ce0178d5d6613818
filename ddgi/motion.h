// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

#include "scenes/world.h"

namespace plumbline::ddgi {

/// Well above the relative rounding of distances, well below what moves in a frame.
constexpr float distance_rounding = 1e-5f;

/// A box along axes of its own: as close around a block that turned as around one that did not.
struct OrientedBox {
    glm::mat3 axes{1.f};  ///< its columns are the axes: of unit length, at right angles
    Bounds bounds;        ///< in coordinates along these axes

    /// A point or vector of the world in the box's coordinates.
    glm::vec3 to_box(const glm::vec3& v) const { return v * axes; }
};

/// A closed box that moved, where it was and where it is, each smaller than it by the rounding of
/// rays: what comes from outside and enters is stopped.
struct SolidMove {
    OrientedBox was;
    OrientedBox is;
};

/// Where an object that moved is now.
struct MovedBox {
    OrientedBox box;  ///< around it, grown by the rounding of rays
    /// Rays that start in here meet only backs of it, and pass; empty if it is no closed box that
    /// shows its one side outward.
    OrientedBox inside;
};

/// What changed from one frame to the next.
struct Motion {
    /// Of every object that moved: where it was and where it is, grown by the rounding of rays; one
    /// box around both where that is no larger than the two.
    std::vector<Bounds> boxes;
    std::vector<OrientedBox> oriented_boxes;  ///< the same along the axes of where objects are
    std::vector<SolidMove> solids;            ///< of the objects that moved, those that are boxes
    std::vector<bool> moved;                  ///< one an object of the world
    bool lights = false;                      ///< a light changed
    std::vector<MovedBox> now;                ///< where all that moved is

    bool none() const { return boxes.empty() && !lights; }
};

/// What moved alone, where it is now.
World moved_part(const World& world, const Motion& motion);

/// Compares two frames of one scene.
Motion motion_between(const World& before, const World& after);

/// The points origin + t direction with 0 <= t <= length, made ready to be held against many
/// boxes; `length` may be infinite.
class BoxRay {
 public:
    BoxRay(const glm::vec3& origin, const glm::vec3& direction, float length);

    /// Whether one of the points is in the box, to within the rounding that Motion::boxes allow.
    bool meets(const Bounds& box) const {
        const glm::vec3 a = (box.lower - origin_) * inverse_;
        const glm::vec3 b = (box.upper - origin_) * inverse_;
        const glm::vec3 enter = glm::min(a, b);
        const glm::vec3 leave = glm::max(a, b);
        return std::max({0.f, enter.x, enter.y, enter.z}) <=
               std::min({length_, leave.x, leave.y, leave.z});
    }

 private:
    glm::vec3 origin_;
    glm::vec3 inverse_;
    float length_;
};

}  // namespace plumbline::ddgi
