// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "scenes/world.h"

namespace plumbline::ddgi {

/// In cells: a probe this near to a surface behind it stands in that surface, and its rays start on
/// both sides of it.
constexpr float in_surface = 1e-3f;

/// All probes around a point, for weights that do not ask which are seen.
constexpr std::uint8_t all_probes = 0xff;

/// The planes that the surfaces in each cell of a grid lie in: from a point to the probes around
/// it, nothing is on a way that crosses none of them. Where walls are larger than cells that is
/// most ways, and no ray need be traced along these.
class CellPlanes {
 public:
    explicit CellPlanes(const ProbeGrid& grid);

    /// Takes in all surfaces of a world.
    void take(const World& world);

    /// Bit k is set if nothing can be on the way from `x`, in the cell with lower corner `lower`,
    /// to probe k around it, or within in_surface cells behind that. A bit that is not set tells
    /// nothing.
    std::uint8_t open_ways(const glm::ivec3& lower, const glm::vec3& x) const;

 private:
    /// The points p with n . p = offset; triangles lie in it to within a quarter of `margin`, and
    /// what is farther from it than `margin` is on one side of them, whatever the rounding.
    struct Plane {
        glm::dvec3 n;  ///< unit
        double offset;
        double margin;

        double height(const glm::dvec3& p) const { return glm::dot(n, p) - offset; }
    };
    using Triangle = std::array<glm::vec3, 3>;
    static constexpr std::size_t most_planes = 4;
    static constexpr std::uint8_t too_many = 0xff;
    /// Bit k of `front` or `behind` is set if probe k, and what is right behind it, is there.
    struct Cell {
        std::uint8_t count = 0;  ///< of planes, or too_many
        std::array<std::uint8_t, most_planes> front, behind;
        std::array<std::uint32_t, most_planes> plane;
    };

    static Plane plane_of(const Triangle& triangle);
    static bool covers(const Plane& plane, const Plane& other, const Triangle& triangle);
    Bounds reach_of(const glm::ivec3& lower) const;
    void add(const Triangle& triangle);
    bool add_last_plane(const glm::ivec3& lower, Cell& cell, const Triangle& triangle);
    void fill_up(const Bounds& bounds);
    template <typename Function>
    void for_cells(const Bounds& bounds, const Function& f);

    ProbeGrid grid_;
    std::vector<Plane> planes_;
    std::vector<Cell> cells_;  ///< each at the index of its lowest probe
};

}  // namespace plumbline::ddgi
