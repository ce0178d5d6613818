// SPDX-License-Identifier: Apache-2.0
#include "ddgi/grid.h"

#include <fmt/core.h>

#include <cmath>

#include "ddgi/grid_cell.h"
#include "scenes/errors.h"
#include "scenes/scene_checks.h"

namespace plumbline::ddgi {
namespace {

/// A spacing that divides the extent up to rounding adds no cell.
constexpr float division_tolerance = 1e-4f;
constexpr float most_probes_along_an_axis = 1024.f;

}  // namespace

ProbeGrid with_spacing(const ProbeGrid& grid, float spacing) {
    if (!(spacing > 0.f && spacing <= farthest_place)) {
        throw UsageError("--spacing", fmt::format("{} is not a distance between probes", spacing),
                         fmt::format("give a length above 0 and up to {:g}; the scene has {}",
                                     farthest_place, grid.spacing));
    }
    const glm::vec3 extent = grid.spacing * glm::vec3(grid.counts - 1);
    const glm::vec3 cells = glm::ceil(extent / spacing - division_tolerance);
    if (max_component(cells) >= most_probes_along_an_axis) {
        throw UsageError("--spacing",
                         fmt::format("{} makes {} probes along an axis", spacing,
                                     static_cast<double>(max_component(cells)) + 1),
                         fmt::format("give {} or more",
                                     max_component(extent) / (most_probes_along_an_axis - 1.f)));
    }
    const glm::vec3 overhang = spacing * cells - extent;
    return {grid.origin - overhang / 2.f, spacing, glm::ivec3(cells) + 1};
}

std::uint32_t cell_probe(const ProbeGrid& grid, const glm::vec3& point) {
    return probe_index(grid, cell_around(grid, place_in(grid, point)));
}

ProbeNeighbours probe_neighbours(const ProbeGrid& grid, const glm::vec3& point) {
    return probe_neighbours(grid, point, point);
}

ProbeNeighbours probe_neighbours(const ProbeGrid& grid, const glm::vec3& point,
                                 const glm::vec3& biased) {
    const glm::ivec3 base = cell_around(grid, place_in(grid, point));
    const glm::vec3 upper = upper_weights(place_in(grid, biased), base);
    const glm::vec3 lower = 1.f - upper;

    ProbeNeighbours result;
    for (unsigned corner = 0; corner < 8; ++corner) {
        const glm::ivec3 offset(corner >> 2u & 1u, corner >> 1u & 1u, corner & 1u);
        const glm::ivec3 cell = glm::min(base + offset, grid.counts - 1);
        result.probe[corner] = probe_index(grid, cell);
        result.weight[corner] = (offset.x != 0 ? upper.x : lower.x) *
                                (offset.y != 0 ? upper.y : lower.y) *
                                (offset.z != 0 ? upper.z : lower.z);
    }
    return result;
}

}  // namespace plumbline::ddgi
