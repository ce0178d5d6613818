// SPDX-License-Identifier: Apache-2.0
#include "ddgi/irradiance_map.h"

#include <algorithm>
#include <cmath>

namespace plumbline::ddgi {
namespace {

/// The lower half folds over the diagonals of the square [-1,1]^2.
glm::vec2 folded(const glm::vec2& p) {
    return {std::copysign(1.f - std::abs(p.y), p.x), std::copysign(1.f - std::abs(p.x), p.y)};
}

/// The direction at a point of the square; the centre is +y, the corners are -y.
glm::vec3 direction_of(const glm::vec2& square) {
    const float height = 1.f - std::abs(square.x) - std::abs(square.y);
    const glm::vec2 flat = height >= 0.f ? square : folded(square);
    return glm::normalize(glm::vec3(flat.x, height, flat.y));
}

}  // namespace

const std::array<glm::vec3, map_nodes>& map_directions() {
    static const auto directions = [] {
        std::array<glm::vec3, map_nodes> nodes;
        constexpr float half = (map_side - 1) / 2.f;
        for (std::size_t i = 0; i < map_nodes; ++i) {
            const glm::vec2 node(i % map_side, i / map_side);
            nodes[i] = direction_of(node / half - 1.f);
        }
        return nodes;
    }();
    return directions;
}

MapPoint map_point(const glm::vec3& n) {
    const glm::vec3 on_octahedron = n / (std::abs(n.x) + std::abs(n.y) + std::abs(n.z));
    const glm::vec2 flat(on_octahedron.x, on_octahedron.z);
    const glm::vec2 square = on_octahedron.y >= 0.f ? flat : folded(flat);
    constexpr float half = (map_side - 1) / 2.f;
    const glm::vec2 at = glm::clamp((square + 1.f) * half, 0.f, 2.f * half);
    const glm::ivec2 base = glm::min(glm::ivec2(at), map_side - 2);
    const glm::vec2 upper = at - glm::vec2(base);
    const glm::vec2 lower = 1.f - upper;
    const int first = base.y * map_side + base.x;
    const auto node = [&](int offset) { return static_cast<std::uint8_t>(first + offset); };
    return {{node(0), node(1), node(map_side), node(map_side + 1)},
            {lower.x * lower.y, upper.x * lower.y, lower.x * upper.y, upper.x * upper.y}};
}

}  // namespace plumbline::ddgi
