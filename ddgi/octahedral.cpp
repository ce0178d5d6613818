// SPDX-License-Identifier: Apache-2.0
#include "ddgi/octahedral.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace plumbline::ddgi {
namespace {

/// The lower half folds over the diagonals of the square [-1,1]^2.
glm::vec2 folded(const glm::vec2& p) {
    return {std::copysign(1.f - std::abs(p.y), p.x), std::copysign(1.f - std::abs(p.x), p.y)};
}

}  // namespace

glm::vec3 octahedral_direction(const glm::vec2& square) {
    const float height = 1.f - std::abs(square.x) - std::abs(square.y);
    const glm::vec2 flat = height >= 0.f ? square : folded(square);
    return glm::normalize(glm::vec3(flat.x, height, flat.y));
}

glm::vec2 octahedral_square(const glm::vec3& n) {
    const glm::vec3 on_octahedron = n / (std::abs(n.x) + std::abs(n.y) + std::abs(n.z));
    const glm::vec2 flat(on_octahedron.x, on_octahedron.z);
    return on_octahedron.y >= 0.f ? flat : folded(flat);
}

OctahedralTexels::OctahedralTexels(int side) : side_(side) {
    assert(static_cast<std::size_t>(side * side) % lanes == 0);
    const float half = static_cast<float>(side) / 2.f;
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
            const glm::vec3 n = octahedral_direction((glm::vec2(column, row) + .5f) / half - 1.f);
            x_.push_back(n.x);
            y_.push_back(n.y);
            z_.push_back(n.z);
        }
    }
}

std::uint16_t OctahedralTexels::texel_at(int column, int row) const {
    const int last = side_ - 1;
    if (column < 0 || column > last) {
        column = std::clamp(column, 0, last);
        row = last - row;
    }
    if (row < 0 || row > last) {
        row = std::clamp(row, 0, last);
        column = last - column;
    }
    return static_cast<std::uint16_t>(row * side_ + column);
}

TexelBlend OctahedralTexels::at(const glm::vec3& n) const {
    const auto side = static_cast<float>(side_);
    const glm::vec2 place = (octahedral_square(n) + 1.f) * (side / 2.f) - .5f;
    const glm::vec2 base = glm::clamp(glm::floor(place), -1.f, side - 1.f);
    const glm::vec2 upper = glm::clamp(place - base, 0.f, 1.f);
    const glm::vec2 lower = 1.f - upper;
    const glm::ivec2 first(base);
    return {{texel_at(first.x, first.y), texel_at(first.x + 1, first.y),
             texel_at(first.x, first.y + 1), texel_at(first.x + 1, first.y + 1)},
            {lower.x * lower.y, upper.x * lower.y, lower.x * upper.y, upper.x * upper.y}};
}

void OctahedralTexels::irradiance(std::span<const RayLight> rays, std::span<float> E) const {
    assert(E.size() == 3 * size());
    for (std::size_t first = 0; first < size(); first += lanes) {
        Lanes weight{};
        std::array<Lanes, 3> sum{};
        for (const auto& [w, L] : rays) {
            const Lanes cosine = lobes(first, w, 1);
            for (std::size_t i = 0; i < lanes; ++i) weight[i] += cosine[i];
            for (std::size_t c = 0; c < 3; ++c) {
                const float radiance = L[static_cast<int>(c)];
                for (std::size_t i = 0; i < lanes; ++i) sum[c][i] += cosine[i] * radiance;
            }
        }
        for (std::size_t c = 0; c < 3; ++c) {
            for (std::size_t i = 0; i < lanes; ++i)
                E[c * size() + first + i] = glm::pi<float>() * sum[c][i] / weight[i];
        }
    }
}

}  // namespace plumbline::ddgi
