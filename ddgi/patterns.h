// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "scenes/geometry.h"

namespace plumbline::ddgi {

constexpr std::size_t octant_count = 8;

/// The directions that a probe of [Dellson 2023, section 3.2] keeps apart, of length sqrt(2).
/// Each stands for an octant of the sphere: its azimuth +-45 degrees, upper or lower half.
constexpr std::array<glm::ivec3, octant_count> principal_directions = {{
    {1, 1, 0},
    {0, 1, 1},
    {-1, 1, 0},
    {0, 1, -1},
    {1, -1, 0},
    {0, -1, 1},
    {-1, -1, 0},
    {0, -1, -1},
}};

/// Unit directions of a probe's surfel rays.
struct RayPattern {
    std::vector<glm::vec3> directions;
    /// Each probe has its own shift of the pattern, see probe_directions().
    bool shifted = false;
    std::vector<int> lattice{};  ///< of sphere_pattern(), which point of the lattice each ray is

    int size() const { return static_cast<int>(directions.size()); }
    /// For patterns sorted by octant: octant d owns [d * per_octant(), (d + 1) * per_octant()).
    std::size_t per_octant() const { return directions.size() / octant_count; }
};

/// The numbers of rays that thesis_pattern() is published for.
constexpr std::array<int, 4> thesis_pattern_sizes = {64, 96, 128, 160};

/// The pattern of [Dellson 2023], sorted by octant: rings even in polar angle, hence denser near
/// the poles.
/// `surfels` is one of thesis_pattern_sizes; throws UsageError otherwise.
RayPattern thesis_pattern(int surfels);

/// Rays that stand for equal solid angles 4 pi / surfels, sorted by octant: in each a golden-ratio
/// lattice, mapped to the sphere by an area-preserving map.
/// `surfels` is a positive multiple of 8; throws UsageError otherwise.
RayPattern even_pattern(int surfels);

/// Rays that stand for equal solid angles 4 pi / surfels: one golden-ratio lattice on the whole
/// sphere, in an order in which those of a block (see RayBlocks) point much the same way. With
/// `shifted`, each probe turns it by its own azimuth and slides it by its own part of the lattice's
/// step in height. `surfels` is a positive multiple of 8; throws UsageError otherwise.
RayPattern sphere_pattern(int surfels, bool shifted);

/// The same rays turned together by rotation number `turn` of a sequence that is even over all
/// rotations: the unit quaternions of [Shoemake 1992] at the points of [Roberts 2018].
RayPattern turned(const RayPattern& pattern, int turn);

/// The directions of the probe at `cell` of its grid.
///
/// The shifts follow a rank-1 lattice over the grid [Roberts 2018], so that probes near each other
/// have unlike shifts: where a look-up blends eight of them their quadrature errors average out.
std::vector<glm::vec3> probe_directions(const RayPattern& pattern, const glm::ivec3& cell);

}  // namespace plumbline::ddgi
