// SPDX-License-Identifier: Apache-2.0
#include "ddgi/cell_planes.h"

#include <algorithm>
#include <cmath>

#include "ddgi/grid.h"
#include "ddgi/grid_cell.h"
#include "scenes/embree_scene.h"

namespace plumbline::ddgi {

CellPlanes::CellPlanes(const ProbeGrid& grid) : grid_(grid), cells_(probe_count(grid)) {}

void CellPlanes::take(const World& world) {
    planes_.clear();
    std::ranges::fill(cells_, Cell{});
    for (const WorldMesh& mesh : world.meshes) {
        for (const glm::uvec3& t : mesh.triangles) {
            add({mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]});
        }
    }
    for (const WorldSphere& sphere : world.spheres) {
        fill_up({sphere.center - sphere.radius, sphere.center + sphere.radius});
    }
}

/// Of a triangle without area the normal is not finite.
CellPlanes::Plane CellPlanes::plane_of(const Triangle& triangle) {
    const auto& [a, b, c] = triangle;
    const glm::dvec3 origin(a);
    const glm::dvec3 n = glm::normalize(glm::cross(glm::dvec3(b) - origin, glm::dvec3(c) - origin));
    const float largest =
        glm::max(largest_coordinate(a), glm::max(largest_coordinate(b), largest_coordinate(c)));
    // Surfels stand twice as far off their surfaces.
    return {n, glm::dot(n, origin), double(position_error(largest)) / 2.};
}

/// Whether `triangle`, which lies in `other`, lies in `plane` too.
bool CellPlanes::covers(const Plane& plane, const Plane& other, const Triangle& triangle) {
    return other.margin <= plane.margin && std::ranges::all_of(triangle, [&](const glm::vec3& p) {
               return std::abs(plane.height(p)) <= plane.margin / 4.;
           });
}

/// The box around all ways in a cell.
Bounds CellPlanes::reach_of(const glm::ivec3& lower) const {
    return cell_bounds(grid_, lower).grown(in_surface * grid_.spacing);
}

/// Calls f(lower, cell) for cells with ways that come within `bounds`.
template <typename Function>
void CellPlanes::for_cells(const Bounds& bounds, const Function& f) {
    const Bounds grown = bounds.grown(2.f * in_surface * grid_.spacing);
    const glm::ivec3 first = cell_around(grid_, place_in(grid_, grown.lower));
    const glm::ivec3 last = cell_around(grid_, place_in(grid_, grown.upper));
    for (int y = first.y; y <= last.y; ++y) {
        for (int x = first.x; x <= last.x; ++x) {
            for (int z = first.z; z <= last.z; ++z) {
                const glm::ivec3 lower(x, y, z);
                const Bounds reach = reach_of(lower);
                if (glm::all(glm::lessThanEqual(reach.lower, bounds.upper)) &&
                    glm::all(glm::lessThanEqual(bounds.lower, reach.upper))) {
                    f(lower, cells_[probe_index(grid_, lower)]);
                }
            }
        }
    }
}

void CellPlanes::fill_up(const Bounds& bounds) {
    for_cells(bounds, [](const glm::ivec3&, Cell& cell) { cell.count = too_many; });
}

void CellPlanes::add(const Triangle& triangle) {
    const Plane plane = plane_of(triangle);
    Bounds bounds;
    for (const glm::vec3& p : triangle) bounds.extend(p);
    bounds = bounds.grown(float(plane.margin));
    if (!std::isfinite(plane.offset)) {
        fill_up(bounds);
        return;
    }
    planes_.push_back(plane);
    bool used = false;
    for_cells(bounds, [&](const glm::ivec3& lower, Cell& cell) {
        if (cell.count != too_many && add_last_plane(lower, cell, triangle)) used = true;
    });
    if (!used) planes_.pop_back();
}

/// Adds the last plane, that of `triangle`, to a cell; false if it is not needed there.
bool CellPlanes::add_last_plane(const glm::ivec3& lower, Cell& cell, const Triangle& triangle) {
    const Plane& plane = planes_.back();
    const auto known = std::span(cell.plane).first(cell.count);
    if (std::ranges::any_of(known,
                            [&](std::uint32_t i) { return covers(planes_[i], plane, triangle); })) {
        return false;
    }
    const Bounds corners = cell_bounds(grid_, lower);
    const double behind_probe = double(in_surface) * double(grid_.spacing);
    const double reach = behind_probe * glm::dot(glm::abs(plane.n), glm::dvec3(1.)) + plane.margin;
    std::uint8_t front = 0, behind = 0;
    for (unsigned k = 0; k < 8; ++k) {
        const double height = plane.height({(k & 4u) != 0 ? corners.upper.x : corners.lower.x,
                                            (k & 2u) != 0 ? corners.upper.y : corners.lower.y,
                                            (k & 1u) != 0 ? corners.upper.z : corners.lower.z});
        if (height > reach) front = static_cast<std::uint8_t>(front | 1u << k);
        if (height < -reach) behind = static_cast<std::uint8_t>(behind | 1u << k);
    }
    if (front == all_probes || behind == all_probes) return false;  // it passes the cell by
    if (cell.count == most_planes) {
        cell.count = too_many;
        return false;
    }
    cell.front[cell.count] = front;
    cell.behind[cell.count] = behind;
    cell.plane[cell.count++] = static_cast<std::uint32_t>(planes_.size() - 1);
    return true;
}

std::uint8_t CellPlanes::open_ways(const glm::ivec3& lower, const glm::vec3& x) const {
    const Cell& cell = cells_[probe_index(grid_, lower)];
    if (cell.count == too_many || !reach_of(lower).contains(x)) return 0;
    std::uint8_t open = all_probes;
    for (std::size_t i = 0; i < cell.count; ++i) {
        const Plane& plane = planes_[cell.plane[i]];
        const double height = plane.height(x);
        const std::uint8_t same_side = height > plane.margin    ? cell.front[i]
                                       : height < -plane.margin ? cell.behind[i]
                                                                : std::uint8_t{0};
        open &= same_side;
    }
    return open;
}

}  // namespace plumbline::ddgi
