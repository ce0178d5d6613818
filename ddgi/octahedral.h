// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "scenes/geometry.h"

namespace plumbline::ddgi {

/// The unit direction at a point of the square [-1,1]^2 that the octahedron unfolds to; the centre
/// is +y, the corners are -y [Cigolle et al. 2014].
glm::vec3 octahedral_direction(const glm::vec2& square);

/// Where octahedral_direction() takes the unit vector `n` from.
glm::vec2 octahedral_square(const glm::vec3& n);

/// What a ray brings: radiance along a unit direction.
struct RayLight {
    glm::vec3 direction;
    Spectrum radiance;
};

/// Four texels of a map and their weights, which are not negative and sum to one.
struct TexelBlend {
    std::array<std::uint16_t, 4> texel;
    std::array<float, 4> weight;
};

/// The texels of an octahedral map, each of which stands for the direction at its centre.
class OctahedralTexels {
 public:
    /// `side` texels along each side of the square, a multiple of 4.
    explicit OctahedralTexels(int side);

    std::size_t size() const { return x_.size(); }
    glm::vec3 direction(std::size_t texel) const { return {x_[texel], y_[texel], z_[texel]}; }

    /// For bilinear interpolation at the unit direction `n`. Across the border of the square lie
    /// the texels that are next to it on the octahedron; published maps keep copies of them in a
    /// border of one texel [Majercik et al. 2019].
    TexelBlend at(const glm::vec3& n) const;

    /// What is summed over texels goes this many at a time, side by side in vector registers.
    static constexpr std::size_t lanes = 8;
    using Lanes = std::array<float, lanes>;

    /// max(0, n_t . w)^power of the texels from `first` on; `power` is at least 1.
    Lanes lobes(std::size_t first, const glm::vec3& w, int power) const {
        Lanes squared;
        Lanes result;
        for (std::size_t i = 0; i < lanes; ++i) {
            const std::size_t t = first + i;
            squared[i] = std::max(0.f, w.x * x_[t] + w.y * y_[t] + w.z * z_[t]);
            result[i] = (power & 1) != 0 ? squared[i] : 1.f;
        }
        // By squaring: std::pow would cost more than all else.
        for (int rest = power >> 1; rest > 0; rest >>= 1) {
            for (float& value : squared) value *= value;
            if ((rest & 1) == 0) continue;
            for (std::size_t i = 0; i < lanes; ++i) result[i] *= squared[i];
        }
        return result;
    }

    /// Irradiance on every texel's direction, channel by channel: pi sum_i w_i L_i / sum_i w_i with
    /// w_i = max(0, n_t . w_i); the rays must stand for equal solid angles all around.
    void irradiance(std::span<const RayLight> rays, std::span<float> E) const;

 private:
    std::uint16_t texel_at(int column, int row) const;

    int side_;
    std::vector<float> x_, y_, z_;  ///< side by side, for vector registers
};

}  // namespace plumbline::ddgi
