// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "scenes/geometry.h"

namespace plumbline::ddgi {

/// Where a normal falls among the nodes of an octahedral map: four nodes and their weights, which
/// are not negative and sum to one.
struct MapPoint {
    std::array<std::uint8_t, 4> node;
    std::array<float, 4> weight;
};

/// Nodes along a side of the square that the octahedron unfolds to; odd, so that the six axes,
/// which most walls face, are nodes.
constexpr int map_side = 7;
constexpr std::size_t map_nodes = std::size_t{map_side} * map_side;

/// The unit directions of the nodes [Cigolle et al. 2014]. Nodes on the border, where the
/// unfolded square meets itself, are there twice, so that no look-up has to wrap around.
const std::array<glm::vec3, map_nodes>& map_directions();

/// The place of the unit direction `n`, for bilinear interpolation.
MapPoint map_point(const glm::vec3& n);

}  // namespace plumbline::ddgi
