// SPDX-License-Identifier: Apache-2.0
#include "scenes/world.h"

#include <fmt/core.h>

#include <cmath>
#include <utility>

#include "scenes/errors.h"
#include "scenes/scene_checks.h"
#include "scenes/tessellate.h"

namespace plumbline {
namespace {

/// The largest relative difference between the scales of two axes that still makes a sphere.
constexpr float even_scale_tolerance = 1e-4f;

glm::vec3 transformed(const glm::mat4& m, const glm::vec3& p) {
    return glm::vec3(m * glm::vec4(p, 1.f));
}

/// In double, where the square of no float overflows or vanishes.
glm::vec3 unit(const glm::vec3& v) { return glm::vec3(glm::normalize(glm::dvec3(v))); }

WorldMesh world_mesh(const Mesh& mesh, const glm::mat4& to_world, int object) {
    WorldMesh result{
        object, {}, mesh.vertex_albedo, mesh.texcoords, mesh.triangles, mesh.triangle_materials};
    result.positions.reserve(mesh.positions.size());
    for (const glm::vec3& p : mesh.positions) result.positions.push_back(transformed(to_world, p));
    // A mirroring transform turns triangles over; swapping two corners turns them back.
    if (glm::determinant(glm::mat3(to_world)) < 0.f) {
        for (glm::uvec3& triangle : result.triangles) std::swap(triangle.y, triangle.z);
    }
    return result;
}

WorldSphere world_sphere(const Sphere& sphere, const glm::mat4& to_world, int object,
                         const Scene& scene) {
    const float x = glm::length(glm::vec3(to_world[0]));
    const float y = glm::length(glm::vec3(to_world[1]));
    const float z = glm::length(glm::vec3(to_world[2]));
    const float tolerance = even_scale_tolerance * x;
    if (std::abs(x - y) > tolerance || std::abs(x - z) > tolerance) {
        throw SceneError(fmt::format("{}: object '{}'", scene.name, scene.objects[object].name),
                         fmt::format("a sphere is scaled unevenly ({}, {}, {})", x, y, z),
                         "scale it alike along all axes, or use a mesh");
    }
    return {object, transformed(to_world, sphere.center), sphere.radius * x, sphere.inward,
            sphere.material};
}

Bounds bounds_of(const WorldMesh& mesh) {
    Bounds bounds;
    for (const glm::vec3& p : mesh.positions) bounds.extend(p);
    return bounds;
}

/// Adds one object's shape, flattened, to the world.
void add_shape(World& world, const Scene& scene, int index) {
    const Object& object = scene.objects[static_cast<std::size_t>(index)];
    World::Object& placed = world.objects[static_cast<std::size_t>(index)];
    const auto add_mesh = [&](const Mesh& mesh) {
        world.meshes.push_back(world_mesh(mesh, placed.to_world, index));
        placed.bounds = bounds_of(world.meshes.back());
    };
    if (const auto* box = std::get_if<Box>(&object.shape)) {
        add_mesh(mesh_of(*box));
    } else if (const auto* quad = std::get_if<Quad>(&object.shape)) {
        add_mesh(mesh_of(*quad));
    } else if (const auto* instance = std::get_if<MeshInstance>(&object.shape)) {
        add_mesh(scene.meshes[static_cast<std::size_t>(instance->mesh)]);
    } else if (const auto* sphere = std::get_if<Sphere>(&object.shape)) {
        const WorldSphere placed_sphere = world_sphere(*sphere, placed.to_world, index, scene);
        // Scaled to nothing it is not there; a radius of zero has no normal.
        if (placed_sphere.radius == 0.f) return;
        world.spheres.push_back(placed_sphere);
        placed.bounds = {placed_sphere.center - placed_sphere.radius,
                         placed_sphere.center + placed_sphere.radius};
    }
}

}  // namespace

Bounds World::bounds() const {
    Bounds all;
    for (const Object& object : objects) all.extend(object.bounds);
    return all;
}

std::size_t World::triangle_count() const {
    std::size_t count = 0;
    for (const WorldMesh& mesh : meshes) count += mesh.triangles.size();
    return count;
}

World world_at(const Scene& scene, int frame) {
    World world;
    world.frame = frame;
    world.materials = scene.materials;
    world.lights = scene.lights;
    for (PointLight& light : world.lights) {
        if (light.cone) light.cone->direction = unit(light.cone->direction);
    }
    world.directional_lights = scene.directional_lights;
    for (DirectionalLight& light : world.directional_lights) {
        light.direction = unit(light.direction);
    }
    world.environment = scene.environment;
    world.environment_image = scene.environment_image;
    world.camera = scene.camera;
    world.objects.reserve(scene.objects.size());
    for (const Object& object : scene.objects) {
        const auto f = static_cast<float>(frame);
        glm::mat4 to_world = transform_at(object.rest, object.animation, f).matrix();
        if (object.parent >= 0) {
            to_world = world.objects[static_cast<std::size_t>(object.parent)].to_world * to_world;
        }
        world.objects.push_back({object.name, to_world, {}});
        add_shape(world, scene, static_cast<int>(world.objects.size()) - 1);
    }
    const Bounds bounds = world.bounds();
    if (!bounds.empty()) world.reach = 2.f * glm::length(bounds.size());
    return world;
}

ProbeGrid probe_grid(const Scene& scene) {
    if (scene.probes) return *scene.probes;
    const Bounds bounds = world_at(scene, 0).bounds();
    if (bounds.empty()) return {};
    // A cell count near the thesis's (20 along an axis), at a fifth of its probes.
    constexpr float cells_along_longest_axis = 12.f;
    const float longest = max_component(bounds.size());
    const float spacing = longest >= smallest_size ? longest / cells_along_longest_axis : 1.f;
    const Bounds grown = bounds.grown(spacing / 2.f);
    const glm::ivec3 counts = glm::ivec3(glm::ceil(grown.size() / spacing)) + 1;
    return {(grown.lower + grown.upper - glm::vec3(counts - 1) * spacing) / 2.f, spacing, counts};
}

}  // namespace plumbline
