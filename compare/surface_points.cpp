// SPDX-License-Identifier: Apache-2.0
#include "compare/surface_points.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <random>

namespace plumbline::compare {

namespace {

/// How far off a surface one looks back at it, of the scene's size.
constexpr float look_back = 1e-4f;
constexpr unsigned seed = 1;

/// A triangle or sphere with the area up to and including it.
struct Patch {
    double area_so_far;
    const WorldMesh* mesh;  ///< null: a sphere
    std::size_t index;      ///< of the triangle, or the sphere
};

std::vector<Patch> patches_of(const World& world) {
    std::vector<Patch> patches;
    double area = 0;
    for (const WorldMesh& mesh : world.meshes)
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            const glm::uvec3& t = mesh.triangles[i];
            const glm::dvec3 a = mesh.positions[t.x], b = mesh.positions[t.y],
                             c = mesh.positions[t.z];
            area += 0.5 * glm::length(glm::cross(b - a, c - a));
            patches.push_back({area, &mesh, i});
        }
    for (std::size_t i = 0; i < world.spheres.size(); ++i) {
        const double r = double(world.spheres[i].radius);
        area += 4 * glm::pi<double>() * r * r;
        patches.push_back({area, nullptr, i});
    }
    return patches;
}

glm::vec3 sphere_direction(const glm::vec2& u) {
    const float z = 1.f - 2.f * u.x, r = std::sqrt(std::max(0.f, 1.f - z * z));
    const float phi = glm::two_pi<float>() * u.y;
    return {r * std::cos(phi), r * std::sin(phi), z};
}

/// A place on a patch, and the normal of its front.
struct Place {
    glm::vec3 position, n;
    int object;
};

Place place_on(const World& world, const Patch& patch, const glm::vec2& u) {
    if (!patch.mesh) {
        const WorldSphere& sphere = world.spheres[patch.index];
        const glm::vec3 d = sphere_direction(u);
        return {sphere.center + sphere.radius * d, sphere.inward ? -d : d, sphere.object};
    }
    const glm::uvec3& t = patch.mesh->triangles[patch.index];
    const auto& p = patch.mesh->positions;
    // Uniform barycentric coordinates [Pharr et al. 2023, section A.5.1].
    const float root = std::sqrt(u.x);
    const float b0 = 1.f - root, b1 = u.y * root;
    return {b0 * p[t.x] + b1 * p[t.y] + (1.f - b0 - b1) * p[t.z],
            glm::normalize(glm::cross(p[t.y] - p[t.x], p[t.z] - p[t.x])), patch.mesh->object};
}

/// The surface at a place, looked at from its side `n`; none if another lies against it.
std::optional<SurfacePoint> seen_from(const RayTracer& tracer, const Place& place,
                                      const glm::vec3& n, float distance) {
    const auto hit = tracer.intersect({place.position + distance * n, -n}, BackFaces::Hit);
    if (!hit || hit->object != place.object || std::abs(hit->t - distance) > 0.5f * distance)
        return std::nullopt;
    return SurfacePoint{offset_origin(*hit, n), n, hit->albedo,
                        tracer.world().materials[std::size_t(hit->material)].emission};
}

}  // namespace

glm::vec3 cosine_direction(const glm::vec2& u, const glm::vec3& n) {
    const glm::vec3 d = n + sphere_direction(u);
    const float length = glm::length(d);
    return length > 0.f ? d / length : n;
}

SurfacePoints surface_points(const RayTracer& tracer, int count) {
    const World& world = tracer.world();
    const std::vector<Patch> patches = patches_of(world);
    SurfacePoints result{{}, 0, 0};
    if (patches.empty()) return result;
    result.area = patches.back().area_so_far / count;
    const float distance = look_back * glm::length(world.bounds().size());
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform;
    for (int i = 0; i < count; ++i) {
        const double at = (i + 0.5) * result.area;
        const auto patch =
            std::lower_bound(patches.begin(), patches.end(), at,
                             [](const Patch& p, double area) { return p.area_so_far < area; });
        const float u = uniform(random);
        const Place place = place_on(world, *patch, {u, uniform(random)});
        const auto front = seen_from(tracer, place, place.n, distance);
        if (front)
            result.points.push_back(*front);
        else
            result.covered_area += result.area;
        const int material = patch->mesh ? patch->mesh->triangle_materials[patch->index]
                                         : world.spheres[patch->index].material;
        if (!world.materials[std::size_t(material)].two_sided) continue;
        if (const auto back = seen_from(tracer, place, -place.n, distance))
            result.points.push_back(*back);
    }
    return result;
}

}  // namespace plumbline::compare
