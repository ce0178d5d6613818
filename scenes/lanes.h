// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "scenes/geometry.h"

namespace plumbline {

/// Rays handled side by side: so few that all that is known of them stays in the first-level cache
/// from one step to the next. A multiple of every vector's width.
inline constexpr std::size_t lane_count = 128;

/// One value for each ray.
template <typename T>
struct alignas(64) Lanes : std::array<T, lane_count> {};

/// One vector for each ray, coordinate by coordinate.
struct Lanes3 {
    Lanes<float> x, y, z;

    glm::vec3 operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
    void set(std::size_t i, const glm::vec3& v) {
        x[i] = v.x;
        y[i] = v.y;
        z[i] = v.z;
    }
};

/// Up to lane_count rays, the first `count` lanes.
struct RayLanes {
    std::size_t count = 0;
    Lanes3 origin, direction;
    Lanes<float> t_max;

    Ray operator[](std::size_t i) const { return {origin[i], direction[i], t_max[i]}; }
    void set(std::size_t i, const Ray& ray) {
        origin.set(i, ray.origin);
        direction.set(i, ray.direction);
        t_max[i] = ray.t_max;
    }
    void push(const Ray& ray) { set(count++, ray); }
};

/// Up to lane_count segments, the first `count` lanes.
struct SegmentLanes {
    std::size_t count = 0;
    Lanes3 a, b;

    Segment operator[](std::size_t i) const { return {a[i], b[i]}; }
    void push(const Segment& segment) {
        a.set(count, segment.a);
        b.set(count, segment.b);
        ++count;
    }
};

}  // namespace plumbline
