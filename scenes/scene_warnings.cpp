// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>

#include "scenes/effects.h"
#include "scenes/inspection.h"
#include "scenes/nearest_name.h"
#include "scenes/nearest_point.h"
#include "scenes/scene_checks.h"

namespace plumbline {
namespace {

std::string many(std::size_t count, const char* one, const char* several) {
    return fmt::format("{} {}", count, count == 1 ? one : several);
}

/// Where normals, the products of two sides, are shorter, Embree puts hits to the first corner.
constexpr double least_normal = 1e-18;

void warn_of_triangles(const World& world, std::vector<std::string>& warnings) {
    for (const WorldMesh& mesh : world.meshes) {
        std::size_t without_area = 0, too_thin = 0;
        for (const glm::uvec3& t : mesh.triangles) {
            // In double, where the products of floats neither round nor underflow.
            const glm::dvec3 a(mesh.positions[t.x]);
            const glm::dvec3 u = glm::dvec3(mesh.positions[t.y]) - a;
            const glm::dvec3 v = glm::dvec3(mesh.positions[t.z]) - a;
            const double normal = glm::length(glm::cross(u, v));
            without_area += normal == 0. ? 1 : 0;
            too_thin += normal > 0. && normal < least_normal ? 1 : 0;
        }
        const std::string who = in_quotes(world.objects[std::size_t(mesh.object)].name);
        if (without_area > 0) {
            warnings.push_back(fmt::format("{} has {} without area: nothing can hit them", who,
                                           many(without_area, "triangle", "triangles")));
        }
        if (too_thin > 0) {
            warnings.push_back(
                fmt::format("{} has {} of an area below {:g}: all hits are put to a "
                            "corner; scale the scene up",
                            who, many(too_thin, "triangle", "triangles"), least_normal / 2.));
        }
    }
}

/// The smallest object that has a size, infinite if none has.
struct Smallest {
    float size = std::numeric_limits<float>::infinity();
    std::string name;
};

Smallest smallest_object(const World& world) {
    Smallest smallest;
    for (const World::Object& object : world.objects) {
        const float size = object.bounds.empty() ? 0.f : max_component(object.bounds.size());
        if (size > 0.f && size < smallest.size) smallest = {size, object.name};
    }
    return smallest;
}

void warn_of_precision(const World& world, std::vector<std::string>& warnings) {
    // A surface is then placed to a ten-thousandth of the smallest object or better.
    constexpr float coarsest = 1e-4f;
    const Bounds bounds = world.bounds();
    if (bounds.empty()) {
        warnings.push_back("nothing to see: no object has a shape at this frame");
        return;
    }
    const float farthest =
        std::max(max_component(glm::abs(bounds.lower)), max_component(glm::abs(bounds.upper)));
    const float step = std::nextafter(farthest, std::numeric_limits<float>::infinity()) - farthest;
    const auto [smallest, name] = smallest_object(world);
    if (smallest < smallest_size) {
        warnings.push_back(
            fmt::format("{} is {:.2g} across: rays may miss what is below {:g}; scale the scene up",
                        in_quotes(name), smallest, smallest_size));
    }
    if (step > coarsest * smallest) {
        warnings.push_back(fmt::format(
            "coordinates reach {:g}, where a float's steps are {:g}: that is {:.2g} of the size of "
            "{} ({:g}); move the scene to the origin",
            farthest, step, step / smallest, in_quotes(name), smallest));
    }
}

/// The object with a surface within `reach` of the point, and how near that surface is.
struct Near {
    int object;
    double distance;
};

std::optional<Near> surface_near(const World& world, const glm::vec3& point, float reach) {
    const glm::dvec3 p(point);
    for (const WorldMesh& mesh : world.meshes) {
        if (!world.objects[std::size_t(mesh.object)].bounds.grown(reach).contains(point)) continue;
        for (const glm::uvec3& t : mesh.triangles) {
            Bounds box;
            for (int i = 0; i < 3; ++i) box.extend(mesh.positions[t[i]]);
            if (!box.grown(reach).contains(point)) continue;
            const double distance =
                glm::length(p - nearest_point(p, glm::dvec3(mesh.positions[t.x]),
                                              glm::dvec3(mesh.positions[t.y]),
                                              glm::dvec3(mesh.positions[t.z])));
            if (distance <= double(reach)) return Near{mesh.object, distance};
        }
    }
    for (const WorldSphere& sphere : world.spheres) {
        const double off_center = glm::length(p - glm::dvec3(sphere.center));
        const double distance = std::abs(off_center - double(sphere.radius));
        if (distance <= double(reach)) return Near{sphere.object, distance};
    }
    return std::nullopt;
}

/// Irradiance of a point with inverse-square falloff has no bound at a surface that it touches.
void warn_of_near_lights(const World& world, std::vector<std::string>& warnings) {
    constexpr float too_near = 1e-4f;  // of the scene's size; the spot is then a pixel at most
    const Bounds bounds = world.bounds();
    if (bounds.empty()) return;
    for (const PointLight& light : world.lights) {
        if (light.falloff != Falloff::InverseSquare || light.radius > 0.f) continue;
        const auto near =
            surface_near(world, light.position, too_near * max_component(bounds.size()));
        if (!near) continue;
        warnings.push_back(fmt::format(
            "light {} is {:.2g} off a surface of {}: almost all that it sends there falls on a "
            "spot that no path finds again, and its bounces are missing; move it off, or give it a "
            "radius",
            in_quotes(light.name), near->distance,
            in_quotes(world.objects[std::size_t(near->object)].name)));
    }
}

}  // namespace

std::vector<std::string> scene_warnings(const Scene& scene, const World& world) {
    std::vector<std::string> warnings;
    warn_of_triangles(world, warnings);
    warn_of_precision(world, warnings);
    warn_of_near_lights(world, warnings);
    if (effects_of(scene) == Effects{}) {
        warnings.push_back(
            "the picture is black: no light, no emitter, and no light from an environment");
    }
    return warnings;
}

}  // namespace plumbline
