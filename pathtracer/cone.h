// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

#include "pathtracer/hemisphere.h"

namespace plumbline::pathtracer {

/// The directions from a point outside a sphere that meet it: a cone around the unit vector
/// `axis`.
struct SphereCone {
    glm::vec3 axis;
    float d2;             ///< squared distance to the centre
    float sin2;           ///< of the cone's half angle
    float one_minus_cos;  ///< of the cone's half angle
    float solid_angle() const { return 2.f * std::numbers::pi_v<float> * one_minus_cos; }
};

/// The cone to a sphere of this radius whose centre lies `to_center` away; `radius` is above 0
/// and below the distance.
inline SphereCone sphere_cone(const glm::vec3& to_center, float radius) {
    const float d2 = glm::dot(to_center, to_center);
    const float sin2 = radius * radius / d2;
    // 1 - sqrt(1 - sin^2) cancels for small spheres; multiplied out it does not.
    const float one_minus_cos = sin2 / (1.f + std::sqrt(1.f - sin2));
    return {to_center / std::sqrt(d2), d2, sin2, one_minus_cos};
}

/// A direction in the cone, evenly by solid angle, from a point `u` of [0,1)^2.
inline glm::vec3 sample_cone(const SphereCone& cone, const glm::vec2& u) {
    const float lower = u.x * cone.one_minus_cos;  // 1 - cos(theta)
    const float sin_theta = std::sqrt(lower * (2.f - lower));
    return from_local({sin_theta * unit_circle(u.y), 1.f - lower}, cone.axis);
}

/// Where a ray of the unit `direction`, inside the cone, enters the sphere of this radius: the
/// distance, at least not beyond it.
inline float distance_to_sphere(const SphereCone& cone, float radius, const glm::vec3& direction) {
    const float cosine = glm::dot(cone.axis, direction);
    const glm::vec3 off_axis = direction - cosine * cone.axis;
    const float half_chord2 = radius * radius - cone.d2 * glm::dot(off_axis, off_axis);
    // Near the rim the difference above is rounding alone, a few epsilons of d^2.
    const float rounding = 8.f * 0x1p-24f * cone.d2;
    return std::sqrt(cone.d2) * cosine - std::sqrt(glm::max(half_chord2, 0.f) + rounding);
}

}  // namespace plumbline::pathtracer
