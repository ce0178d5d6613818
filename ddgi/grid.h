// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "scenes/scene.h"

namespace plumbline::ddgi {

/// How many probes a grid has.
inline std::uint32_t probe_count(const ProbeGrid& grid) {
    return static_cast<std::uint32_t>(grid.counts.x * grid.counts.y * grid.counts.z);
}

/// Where a probe is stored: layer by layer in y; within a layer, lines of constant x; z contiguous
/// [Dellson 2023, section 4.3.3].
inline std::uint32_t probe_index(const ProbeGrid& grid, const glm::ivec3& cell) {
    return static_cast<std::uint32_t>((cell.y * grid.counts.x + cell.x) * grid.counts.z + cell.z);
}

/// The inverse of probe_index.
inline glm::ivec3 probe_cell(const ProbeGrid& grid, std::uint32_t probe) {
    const auto index = static_cast<int>(probe);
    const int line = index / grid.counts.z;
    return {line % grid.counts.x, line / grid.counts.x, index % grid.counts.z};
}

/// Where a probe stands, world space.
inline glm::vec3 probe_position(const ProbeGrid& grid, std::uint32_t probe) {
    return grid.origin + grid.spacing * glm::vec3(probe_cell(grid, probe));
}

/// The grid over the same extent with another spacing, centred on it; where the spacing does not
/// divide the extent the new grid reaches over it by less than a cell.
/// Throws UsageError if the spacing is not positive or the grid would be too large to index.
ProbeGrid with_spacing(const ProbeGrid& grid, float spacing);

/// The eight probes around a point and their trilinear weights, which sum to one.
struct ProbeNeighbours {
    std::array<std::uint32_t, 8> probe;
    std::array<float, 8> weight;
};

/// The lowest of the eight probes around a point: which cell it is in.
std::uint32_t cell_probe(const ProbeGrid& grid, const glm::vec3& point);

/// The cell around `point`, which is first clamped into the grid [Dellson 2023, listing 4.1].
ProbeNeighbours probe_neighbours(const ProbeGrid& grid, const glm::vec3& point);

/// The same cell, with the weights of `biased`, which is first clamped into that cell.
ProbeNeighbours probe_neighbours(const ProbeGrid& grid, const glm::vec3& point,
                                 const glm::vec3& biased);

}  // namespace plumbline::ddgi
