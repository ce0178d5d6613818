// SPDX-License-Identifier: Apache-2.0
// What stands behind Embree's answers, for one ray and for many side by side.
#include <cmath>

#include "scenes/embree_scene.h"
#include "scenes/kept_lanes.h"
#include "scenes/wide.h"

namespace plumbline {

/// A triangle's corners, for each ray.
struct EmbreeScene::CornerLanes {
    Lanes3 a, b, c;
};

namespace {

/// The point of barycentric coordinates u and v. Interpolated, not origin + t direction, whose
/// error grows with the distance.
template <typename Value>
Value interpolate(const Value& a, const Value& b, const Value& c, float u, float v) {
    return (1.f - u - v) * a + u * b + v * c;
}

float triangle_error(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    return position_error(
        glm::max(largest_coordinate(a), glm::max(largest_coordinate(b), largest_coordinate(c))));
}

PLUMBLINE_WIDE void find_met(std::size_t rays, const EmbreeScene::FoundLanes& found,
                             Lanes<std::int32_t>& met, Lanes<std::uint32_t>& ray) {
#pragma GCC ivdep
    for (std::size_t i = 0; i < rays; ++i) {
        met[i] = found.geometry[i] != RTC_INVALID_GEOMETRY_ID ? 1 : 0;
        ray[i] = static_cast<std::uint32_t>(i);
    }
}

void close_up(const KeptLanes& kept, EmbreeScene::FoundLanes& found) {
    kept.close_up(found.geometry);
    kept.close_up(found.primitive);
    kept.close_up(found.t);
    kept.close_up(found.u);
    kept.close_up(found.v);
    kept.close_up(found.ng);
}

/// Where on their triangles the rays met them, and on which side.
PLUMBLINE_WIDE void meet_triangles(const Lanes3& direction, const EmbreeScene::FoundLanes& found,
                                   const Lanes3& corner_a, const Lanes3& corner_b,
                                   const Lanes3& corner_c, HitLanes& hits) {
#pragma GCC ivdep
    for (std::size_t i = 0; i < hits.count; ++i) {
        const glm::vec3 a = corner_a[i], b = corner_b[i], c = corner_c[i];
        hits.position.set(i, interpolate(a, b, c, found.u[i], found.v[i]));
        hits.position_error[i] = triangle_error(a, b, c);
        const glm::vec3 ng = unit_length(found.ng[i]);
        const bool back = glm::dot(ng, direction[i]) > 0.f;
        hits.back[i] = back ? 1 : 0;
        hits.n.set(i, back ? -ng : ng);
    }
}

}  // namespace

Hit EmbreeScene::triangle_hit(const WorldMesh& mesh, const Found& found) const {
    const glm::uvec3& triangle = mesh.triangles[found.primitive];
    const glm::vec3& a = mesh.positions[triangle.x];
    const glm::vec3& b = mesh.positions[triangle.y];
    const glm::vec3& c = mesh.positions[triangle.z];
    Hit hit{};
    hit.object = mesh.object;
    hit.material = mesh.triangle_materials[found.primitive];
    hit.position = interpolate(a, b, c, found.u, found.v);
    hit.position_error = triangle_error(a, b, c);
    hit.ng = unit_length(found.ng);
    const Material& material = world_.materials[static_cast<std::size_t>(hit.material)];
    hit.albedo = material.albedo;
    const auto between_corners = [&](const auto& values) {
        return interpolate(values[triangle.x], values[triangle.y], values[triangle.z], found.u,
                           found.v);
    };
    if (!mesh.vertex_albedo.empty()) hit.albedo *= between_corners(mesh.vertex_albedo);
    if (material.texture) hit.albedo *= material.texture->at(between_corners(mesh.texcoords));
    return hit;
}

Hit EmbreeScene::sphere_hit(const WorldSphere& sphere, const Ray& ray, float t) const {
    Hit hit{};
    hit.object = sphere.object;
    hit.material = sphere.material;
    const glm::vec3 outward = glm::normalize(ray.origin + t * ray.direction - sphere.center);
    hit.position = sphere.center + sphere.radius * outward;
    hit.position_error = position_error(largest_coordinate(sphere.center) + sphere.radius);
    hit.ng = sphere.inward ? -outward : outward;
    hit.albedo = world_.materials[static_cast<std::size_t>(hit.material)].albedo;
    return hit;
}

Hit EmbreeScene::hit(const Ray& ray, const Found& found) const {
    const Geometry& geometry = geometries_[found.geometry];
    Hit hit = geometry.mesh != nullptr ? triangle_hit(*geometry.mesh, found)
                                       : sphere_hit(*geometry.sphere, ray, found.t);
    hit.t = found.t;
    hit.geometry = found.geometry;
    hit.primitive = found.primitive;
    hit.back = glm::dot(hit.ng, ray.direction) > 0.f;
    return hit;
}

void EmbreeScene::hits(const RayLanes& rays, FoundLanes& found, HitLanes& hits) const {
    Lanes<std::int32_t> flags;
    find_met(rays.count, found, flags, hits.ray);
    const KeptLanes met(rays.count, flags);
    hits.count = met.count();
    Lanes3 closed_up;
    const Lanes3* direction = &rays.direction;
    if (hits.count < rays.count) {
        close_up(met, found);
        met.close_up(hits.ray);
        met.close_up(rays.direction, closed_up);
        direction = &closed_up;
    }
    hits.t = found.t;
    hits.geometry = found.geometry;
    hits.primitive = found.primitive;
    CornerLanes corners;
    std::size_t plain = 0;
    for (std::size_t i = 0; i < hits.count; ++i) {
        if (geometries_[found.geometry[i]].plain) {
            fetch_triangle(found, i, corners, hits);
            ++plain;
        } else {
            corners.a.set(i, glm::vec3(0.f));
            corners.b.set(i, glm::vec3(0.f));
            corners.c.set(i, glm::vec3(0.f));
        }
    }
    meet_triangles(*direction, found, corners.a, corners.b, corners.c, hits);
    if (plain == hits.count) return;
    for (std::size_t i = 0; i < hits.count; ++i) {
        if (!geometries_[found.geometry[i]].plain) hits.set(i, hit(rays[hits.ray[i]], found[i]));
    }
}

void EmbreeScene::fetch_triangle(const FoundLanes& found, std::size_t i, CornerLanes& corners,
                                 HitLanes& hits) const {
    const WorldMesh& mesh = *geometries_[found.geometry[i]].mesh;
    const glm::uvec3& triangle = mesh.triangles[found.primitive[i]];
    corners.a.set(i, mesh.positions[triangle.x]);
    corners.b.set(i, mesh.positions[triangle.y]);
    corners.c.set(i, mesh.positions[triangle.z]);
    hits.object[i] = mesh.object;
    hits.material[i] = mesh.triangle_materials[found.primitive[i]];
    hits.albedo.set(i, world_.materials[static_cast<std::size_t>(hits.material[i])].albedo);
}

}  // namespace plumbline
