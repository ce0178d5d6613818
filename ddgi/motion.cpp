// SPDX-License-Identifier: Apache-2.0
#include "ddgi/motion.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <optional>

namespace plumbline::ddgi {
namespace {

/// Of a box's largest coordinate: well above the rounding of ray tracing, well below any object.
constexpr float rounding_margin = 1e-5f;

float margin_of(const Bounds& box) {
    return rounding_margin * max_component(glm::max(glm::abs(box.lower), glm::abs(box.upper)));
}

Bounds with_margin(const Bounds& box) { return box.grown(margin_of(box)); }

/// Half the surface: how likely a box is met by a ray [Pharr et al. 2023, section 7.3.2].
float half_area(const Bounds& box) {
    const glm::vec3 size = box.size();
    return size.x * size.y + size.y * size.z + size.z * size.x;
}

/// Where an object was, and where it is.
std::vector<Bounds> boxes_around(const Bounds& was, const Bounds& is) {
    Bounds both = was;
    both.extend(is);
    // A sphere scaled to nothing has no box, but it had one, or will have.
    const bool one_empty = was.empty() || is.empty();
    if (one_empty || half_area(both) <= half_area(was) + half_area(is)) return {with_margin(both)};
    return {with_margin(was), with_margin(is)};
}

/// Axes of unit length at right angles, those of `to_world` where it neither shears nor flattens.
glm::mat3 axes_of(const glm::mat4& to_world) {
    const glm::vec3 x(to_world[0]);
    const glm::vec3 z = glm::cross(x, glm::vec3(to_world[1]));
    const float area = glm::length(z);
    if (!(area > 0.f) || !std::isfinite(area)) return glm::mat3(1.f);
    const glm::vec3 unit_x = unit_length(x);
    const glm::vec3 unit_z = z / area;
    return {unit_x, glm::cross(unit_z, unit_x), unit_z};
}

/// Of each object that moved, the box around it along its `axes`.
std::vector<Bounds> bounds_along(const World& world, const std::vector<glm::mat3>& axes,
                                 const std::vector<bool>& moved) {
    std::vector<Bounds> bounds(axes.size());
    for (const WorldMesh& mesh : world.meshes) {
        const auto object = static_cast<std::size_t>(mesh.object);
        if (!moved[object]) continue;
        for (const glm::vec3& p : mesh.positions) bounds[object].extend(p * axes[object]);
    }
    for (const WorldSphere& sphere : world.spheres) {
        const auto object = static_cast<std::size_t>(sphere.object);
        if (!moved[object]) continue;
        const glm::vec3 center = sphere.center * axes[object];
        bounds[object].extend(Bounds{center - sphere.radius, center + sphere.radius});
    }
    return bounds;
}

/// The corner of `box` at `p`, a bit an axis that is set for the upper end; none if `p` is no
/// corner to within `tolerance`.
std::optional<unsigned> corner_at(const Bounds& box, const glm::vec3& p, float tolerance) {
    unsigned corner = 0;
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(p[axis] - box.upper[axis]) <= tolerance) {
            corner |= 1u << axis;
        } else if (std::abs(p[axis] - box.lower[axis]) > tolerance) {
            return std::nullopt;
        }
    }
    return corner;
}

/// Whether triangles of these corners are a closed box: two on each face, which leave out opposite
/// corners of it.
bool closes_a_box(const std::vector<std::array<unsigned, 3>>& triangles) {
    std::array<std::vector<unsigned>, 6> left_out;
    for (const auto& [a, b, c] : triangles) {
        const unsigned constant = ~((a ^ b) | (b ^ c)) & 7u;  // the bit that all three share
        if (!std::has_single_bit(constant)) return false;
        const auto axis = static_cast<std::size_t>(std::countr_zero(constant));
        const std::size_t face = 2 * axis + ((a & constant) != 0 ? 1 : 0);
        left_out[face].push_back(a ^ b ^ c);  // of a face's four corners the fourth
    }
    return std::ranges::all_of(left_out, [](const std::vector<unsigned>& corners) {
        return corners.size() == 2 && std::popcount(corners[0] ^ corners[1]) == 2;
    });
}

/// The core of a mesh that is a closed box along `axes`.
std::optional<OrientedBox> solid_core(const WorldMesh& mesh, const glm::mat3& axes) {
    constexpr std::size_t triangles_of_a_box = 12;
    if (mesh.triangles.size() != triangles_of_a_box) return std::nullopt;
    Bounds bounds;
    for (const glm::vec3& p : mesh.positions) bounds.extend(p * axes);
    const float margin = margin_of(bounds);
    const Bounds core = bounds.grown(-2.f * margin);
    if (!(min_component(core.size()) > 0.f)) return std::nullopt;
    std::vector<std::array<unsigned, 3>> triangles;
    for (const glm::uvec3& triangle : mesh.triangles) {
        const auto corner = [&](unsigned vertex) {
            return corner_at(bounds, mesh.positions[vertex] * axes, margin);
        };
        const auto a = corner(triangle.x);
        const auto b = corner(triangle.y);
        const auto c = corner(triangle.z);
        if (!a || !b || !c) return std::nullopt;
        triangles.push_back({*a, *b, *c});
    }
    if (!closes_a_box(triangles)) return std::nullopt;
    return OrientedBox{axes, core};
}

/// Whether all triangles of a mesh whose middle is `middle` show their one side away from it.
bool shows_outside_only(const World& world, const WorldMesh& mesh, const glm::vec3& middle) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const glm::uvec3& triangle = mesh.triangles[i];
        const glm::vec3& a = mesh.positions[triangle.x];
        const glm::vec3 ng =
            glm::cross(mesh.positions[triangle.y] - a, mesh.positions[triangle.z] - a);
        const auto material = static_cast<std::size_t>(mesh.triangle_materials[i]);
        if (world.materials[material].two_sided || !(glm::dot(ng, a - middle) > 0.f)) return false;
    }
    return true;
}

/// The box of MovedBox::inside of what moved as object `object`, along `axes`.
OrientedBox inside_of(const World& world, std::size_t object, const glm::mat3& axes) {
    const auto belongs = [&](const auto& part) {
        return static_cast<std::size_t>(part.object) == object;
    };
    const auto mesh = std::ranges::find_if(world.meshes, belongs);
    if (mesh == world.meshes.end() || std::ranges::any_of(world.spheres, belongs) ||
        std::any_of(std::next(mesh), world.meshes.end(), belongs)) {
        return {};
    }
    const std::optional<OrientedBox> core = solid_core(*mesh, axes);
    if (!core) return {};
    const glm::vec3 middle = core->axes * ((core->bounds.lower + core->bounds.upper) / 2.f);
    return shows_outside_only(world, *mesh, middle) ? *core : OrientedBox{};
}

std::vector<SolidMove> solid_moves(const World& before, const World& after,
                                   const std::vector<bool>& moved) {
    std::vector<SolidMove> moves;
    if (before.meshes.size() != after.meshes.size()) return moves;
    const auto core_of = [](const World& world, std::size_t mesh) {
        const auto object = static_cast<std::size_t>(world.meshes[mesh].object);
        return solid_core(world.meshes[mesh], axes_of(world.objects[object].to_world));
    };
    for (std::size_t i = 0; i < after.meshes.size(); ++i) {
        if (!moved[static_cast<std::size_t>(after.meshes[i].object)]) continue;
        const std::optional<OrientedBox> was = core_of(before, i);
        const std::optional<OrientedBox> is = core_of(after, i);
        if (was && is) moves.push_back({*was, *is});
    }
    return moves;
}

}  // namespace

Motion motion_between(const World& before, const World& after) {
    assert(before.objects.size() == after.objects.size());
    Motion motion;
    motion.moved.resize(after.objects.size(), false);
    motion.lights =
        before.lights != after.lights || before.directional_lights != after.directional_lights;
    std::vector<glm::mat3> axes;
    for (std::size_t i = 0; i < after.objects.size(); ++i) {
        // A turning object may keep its box, so transforms are compared.
        motion.moved[i] = before.objects[i].to_world != after.objects[i].to_world;
        axes.push_back(axes_of(after.objects[i].to_world));
    }
    if (std::ranges::find(motion.moved, true) == motion.moved.end()) return motion;
    motion.solids = solid_moves(before, after, motion.moved);
    const std::vector<Bounds> was = bounds_along(before, axes, motion.moved);
    const std::vector<Bounds> is = bounds_along(after, axes, motion.moved);
    for (std::size_t i = 0; i < after.objects.size(); ++i) {
        if (was[i].empty() && is[i].empty()) continue;  // at rest, or without surfaces
        std::ranges::copy(boxes_around(before.objects[i].bounds, after.objects[i].bounds),
                          std::back_inserter(motion.boxes));
        for (const Bounds& bounds : boxes_around(was[i], is[i])) {
            motion.oriented_boxes.push_back({axes[i], bounds});
        }
        if (is[i].empty()) continue;
        motion.now.push_back({{axes[i], with_margin(is[i])}, inside_of(after, i, axes[i])});
    }
    return motion;
}

World moved_part(const World& world, const Motion& motion) {
    const auto moved = [&](const auto& part) {
        return motion.moved[static_cast<std::size_t>(part.object)];
    };
    World movers;
    movers.objects = world.objects;
    movers.materials = world.materials;
    std::ranges::copy_if(world.meshes, std::back_inserter(movers.meshes), moved);
    std::ranges::copy_if(world.spheres, std::back_inserter(movers.spheres), moved);
    return movers;
}

BoxRay::BoxRay(const glm::vec3& origin, const glm::vec3& direction, float length)
    : origin_(origin), length_(length) {
    // 1 / 0 would give 0 * infinity, NaN, for an origin on the box's plane.
    constexpr float steepest = 1e-30f;
    for (int axis = 0; axis < 3; ++axis) {
        inverse_[axis] = 1.f / (direction[axis] == 0.f ? steepest : direction[axis]);
    }
}

}  // namespace plumbline::ddgi
