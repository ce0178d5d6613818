// SPDX-License-Identifier: Apache-2.0
#include "ddgi/irradiance_map.h"

#include "ddgi/octahedral.h"

namespace plumbline::ddgi {

const std::array<glm::vec3, map_nodes>& map_directions() {
    static const auto directions = [] {
        std::array<glm::vec3, map_nodes> nodes;
        constexpr float half = (map_side - 1) / 2.f;
        for (std::size_t i = 0; i < map_nodes; ++i) {
            const glm::vec2 node(i % map_side, i / map_side);
            nodes[i] = octahedral_direction(node / half - 1.f);
        }
        return nodes;
    }();
    return directions;
}

MapPoint map_point(const glm::vec3& n) {
    constexpr float half = (map_side - 1) / 2.f;
    const glm::vec2 at = glm::clamp((octahedral_square(n) + 1.f) * half, 0.f, 2.f * half);
    const glm::ivec2 base = glm::min(glm::ivec2(at), map_side - 2);
    const glm::vec2 upper = at - glm::vec2(base);
    const glm::vec2 lower = 1.f - upper;
    const int first = base.y * map_side + base.x;
    const auto node = [&](int offset) { return static_cast<std::uint8_t>(first + offset); };
    return {{node(0), node(1), node(map_side), node(map_side + 1)},
            {lower.x * lower.y, upper.x * lower.y, lower.x * upper.y, upper.x * upper.y}};
}

}  // namespace plumbline::ddgi
