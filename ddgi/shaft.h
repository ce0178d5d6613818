// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "ddgi/moved_rays.h"

namespace plumbline::ddgi {

/// Half the size of `box` along `axis`.
inline float half_width(const Bounds& box, const glm::vec3& axis) {
    return glm::dot(box.size() / 2.f, glm::abs(axis));
}

/// The ways to a light from all points of a cube, in the coordinates of a box: a shaft [Haines and
/// Wallace 1994].
class Shaft {
 public:
    /// From all that is less than `reach` from `middle` along each axis.
    Shaft(const LampWay& light, const OrientedBox& box, const glm::vec3& middle, float reach)
        : from_(box.to_box(middle)), length_(light.length) {
        const bool far = light.direction != glm::vec3(0.f);
        way_ = far ? box.to_box(light.direction) : box.to_box(light.position) - from_;
        const Bounds cube{glm::vec3(-reach), glm::vec3(reach)};
        spread_ = {half_width(cube, box.axes[0]), half_width(cube, box.axes[1]),
                   half_width(cube, box.axes[2])};
        narrowing_ = far ? glm::vec3(0.f) : spread_;
    }

    /// Whether some of the ways may meet `bounds`.
    bool may_meet(const Bounds& bounds) const { return meets(bounds, 1.f); }
    /// Whether all of them meet `bounds`, all at the same part of the way.
    bool all_meet(const Bounds& bounds) const { return meets(bounds, -1.f); }

 private:
    /// Whether the way from the middle, from + t way, meets bounds that are larger by sign (spread
    /// - t narrowing): what other ways are off it.
    bool meets(const Bounds& bounds, float sign) const {
        float enter = 0.f;
        float leave = length_;
        // Clips to where start + t slope >= 0.
        const auto clip = [&](float start, float slope) {
            if (slope > 0.f) {
                enter = std::max(enter, -start / slope);
            } else if (slope < 0.f) {
                leave = std::min(leave, -start / slope);
            } else if (start < 0.f) {
                leave = -1.f;
            }
        };
        for (int axis = 0; axis < 3; ++axis) {
            const float spread = sign * spread_[axis];
            const float narrowing = sign * narrowing_[axis];
            clip(from_[axis] - bounds.lower[axis] + spread, way_[axis] - narrowing);
            clip(bounds.upper[axis] - from_[axis] + spread, -way_[axis] - narrowing);
        }
        return enter <= leave;
    }

    glm::vec3 from_, way_, spread_, narrowing_;
    float length_;
};

}  // namespace plumbline::ddgi
