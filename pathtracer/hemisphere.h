// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

namespace plumbline::pathtracer {

/// The vector with these coordinates in an orthonormal basis whose third axis is the unit vector
/// `n`.
inline glm::vec3 from_local(const glm::vec3& local, const glm::vec3& n) {
    // A basis without a branch; the sign keeps 1 + |n.z| away from 0
    // [Duff et al. 2017, "Building an Orthonormal Basis, Revisited"].
    const float sign = std::copysign(1.f, n.z);
    const float a = -1.f / (sign + n.z);
    const float b = n.x * n.y * a;
    const glm::vec3 tangent(1.f + sign * n.x * n.x * a, sign * b, -sign * n.x);
    const glm::vec3 bitangent(b, sign + n.y * n.y * a, -n.y);
    return tangent * local.x + bitangent * local.y + n * local.z;
}

/// A direction on the hemisphere around the unit vector `n` with density cos / pi, from a point `u`
/// of [0,1)^2: a disk lifted to the hemisphere [Malley's method, Pharr et al. 2023, section A.5.3].
///
/// Its cosine with `n` is at least 2^-12, since u.x is at most 1 - 2^-24.
inline glm::vec3 sample_cosine_hemisphere(const glm::vec2& u, const glm::vec3& n) {
    const float r = std::sqrt(u.x);
    const float phi = 2.f * std::numbers::pi_v<float> * u.y;
    return from_local({r * std::cos(phi), r * std::sin(phi), std::sqrt(1.f - u.x)}, n);
}

/// Density of sample_cosine_hemisphere() per unit of solid angle, for a cosine with `n`.
inline float pdf_cosine_hemisphere(float cosine) {
    return cosine > 0.f ? cosine / std::numbers::pi_v<float> : 0.f;
}

}  // namespace plumbline::pathtracer
