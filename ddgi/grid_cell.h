// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenes/scene.h"

namespace plumbline::ddgi {

/// A point, clamped into the grid [Dellson 2023, listing 4.1], in cells from its origin.
inline glm::vec3 place_in(const ProbeGrid& grid, const glm::vec3& point) {
    return glm::clamp((point - grid.origin) / grid.spacing, glm::vec3(0.f),
                      glm::vec3(grid.counts - 1));
}

/// The lower corner of the cell at a place_in(); a point on the last layer belongs to the cell
/// before it.
inline glm::ivec3 cell_around(const ProbeGrid& grid, const glm::vec3& place) {
    return glm::max(glm::min(glm::ivec3(place), grid.counts - 2), 0);
}

/// The box that the eight probes around a point stand at the corners of; flat where the grid is one
/// probe thick. Computed as probe_position() does, so that no bit differs.
inline Bounds cell_bounds(const ProbeGrid& grid, const glm::ivec3& lower) {
    return {grid.origin + grid.spacing * glm::vec3(lower),
            grid.origin + grid.spacing * glm::vec3(glm::min(lower + 1, grid.counts - 1))};
}

/// How far a place_in() is along each axis of its cell, from 0 to 1: the trilinear weights are
/// products of these and what they leave of 1.
inline glm::vec3 upper_weights(const glm::vec3& place, const glm::ivec3& lower) {
    return glm::clamp(place - glm::vec3(lower), 0.f, 1.f);
}

}  // namespace plumbline::ddgi
