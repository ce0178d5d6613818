// SPDX-License-Identifier: Apache-2.0
#pragma once

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

    /// lobe[t] = max(0, n_t . w)^power of every texel t; `power` is at least 1.
    void lobes(const glm::vec3& w, int power, std::span<float> lobe) const;

 private:
    std::uint16_t texel_at(int column, int row) const;

    int side_;
    std::vector<float> x_, y_, z_;  ///< side by side, for vector registers
};

}  // namespace plumbline::ddgi
