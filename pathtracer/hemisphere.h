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

/// The point of the unit circle at `turn` of a full turn from (1, 0), for a turn from 0 to 1, to 4
/// roundings. Unlike the library's functions, the polynomials run in vector registers.
inline glm::vec2 unit_circle(float turn) {
    // The nearest quarter, by truncation since no turn is negative, and what is left of the angle:
    // exact up to the product with pi / 2.
    const int quarter = static_cast<int>(4.f * turn + .5f);  // NOLINT(bugprone-incorrect-roundings)
    const float a = (4.f * turn - static_cast<float>(quarter)) * (std::numbers::pi_v<float> / 2.f);
    const float a2 = a * a;
    // Minimax polynomials on [-pi/4, pi/4] [Moshier 1992, sinf.c].
    const float sine =
        a + a * a2 * (-1.6666654611e-1f + a2 * (8.3321608736e-3f - a2 * 1.9515295891e-4f));
    const float cosine =
        1.f - .5f * a2 +
        a2 * a2 *
            (4.166664568298827e-2f - a2 * (1.388731625493765e-3f - a2 * 2.443315711809948e-5f));
    const bool odd = (quarter & 1) != 0;
    const float x = odd ? sine : cosine;
    const float y = odd ? cosine : sine;
    return {((quarter + 1) & 2) != 0 ? -x : x, (quarter & 2) != 0 ? -y : y};
}

/// A direction on the hemisphere around the unit vector `n` with density cos / pi, from a point `u`
/// of [0,1)^2: a disk lifted to the hemisphere [Malley's method, Pharr et al. 2023, section A.5.3].
///
/// Its cosine with `n` is at least 2^-12, since u.x is at most 1 - 2^-24.
inline glm::vec3 sample_cosine_hemisphere(const glm::vec2& u, const glm::vec3& n) {
    const float r = std::sqrt(u.x);
    const glm::vec2 disk = r * unit_circle(u.y);
    return from_local({disk, std::sqrt(1.f - u.x)}, n);
}

/// Density of sample_cosine_hemisphere() per unit of solid angle, for a cosine with `n`.
inline float pdf_cosine_hemisphere(float cosine) {
    return cosine > 0.f ? cosine / std::numbers::pi_v<float> : 0.f;
}

}  // namespace plumbline::pathtracer
