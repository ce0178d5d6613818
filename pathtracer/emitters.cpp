// SPDX-License-Identifier: Apache-2.0
#include "pathtracer/emitters.h"

#include <cmath>
#include <numbers>

namespace plumbline::pathtracer {
namespace {

constexpr float pi = std::numbers::pi_v<float>;
constexpr std::uint32_t none = ~0u;

/// The normal of a triangle's front times twice its area; in double, where it cannot underflow.
glm::dvec3 area_normal(const WorldMesh& mesh, std::uint32_t primitive) {
    const glm::uvec3& t = mesh.triangles[primitive];
    const glm::dvec3 a(mesh.positions[t.x]);
    return glm::cross(glm::dvec3(mesh.positions[t.y]) - a, glm::dvec3(mesh.positions[t.z]) - a);
}

bool is_inside(const WorldSphere& sphere, const glm::vec3& point) {
    const glm::vec3 way = sphere.center - point;
    return glm::dot(way, way) <= sphere.radius * sphere.radius;
}

/// Density by solid angle of a point chosen evenly by area, at the squared distance `d2`.
float pdf_by_angle(float d2, float cosine_at_emitter, float area) {
    return d2 / (cosine_at_emitter * area);
}

float area_of(const WorldSphere& sphere) { return 4.f * pi * sphere.radius * sphere.radius; }

}  // namespace

Emitters::Emitters(const World& world)
    : world_(world), emitter_of_(world.meshes.size() + world.spheres.size()), tree_([&] {
          std::vector<LightBounds> bounds;
          for (std::size_t i = 0; i < world.meshes.size(); ++i) {
              add_mesh(world.meshes[i], static_cast<int>(i), bounds);
          }
          for (std::size_t i = 0; i < world.spheres.size(); ++i) {
              add_sphere(world.spheres[i], static_cast<int>(i), bounds);
          }
          return LightTree(bounds);
      }()) {}

void Emitters::add_mesh(const WorldMesh& mesh, int index, std::vector<LightBounds>& bounds) {
    std::vector<std::uint32_t>& emitter_of = emitter_of_[static_cast<std::size_t>(index)];
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Material& material =
            world_.materials[static_cast<std::size_t>(mesh.triangle_materials[i])];
        if (material.emission == Spectrum(0.f)) continue;
        const auto primitive = static_cast<std::uint32_t>(i);
        const glm::dvec3 normal = area_normal(mesh, primitive);
        const auto area = static_cast<float>(glm::length(normal) / 2.);
        if (!(area > 0.f)) continue;  // nothing can hit it
        LightBounds light;
        for (int c = 0; c < 3; ++c) light.box.extend(mesh.positions[mesh.triangles[i][c]]);
        light.normals = {glm::vec3(glm::normalize(normal)), 0.f};
        light.two_sided = material.two_sided;
        light.power = area * strength(material.emission);
        emitter_of.resize(mesh.triangles.size(), none);
        emitter_of[i] = static_cast<std::uint32_t>(emitters_.size());
        emitters_.push_back({index, primitive, material.emission, material.two_sided});
        bounds.push_back(light);
    }
}

void Emitters::add_sphere(const WorldSphere& sphere, int index, std::vector<LightBounds>& bounds) {
    const Material& material = world_.materials[static_cast<std::size_t>(sphere.material)];
    if (material.emission == Spectrum(0.f)) return;
    LightBounds light;
    light.box = {sphere.center - sphere.radius, sphere.center + sphere.radius};
    light.power = area_of(sphere) * strength(material.emission);
    emitter_of_[world_.meshes.size() + static_cast<std::size_t>(index)] = {
        static_cast<std::uint32_t>(emitters_.size())};
    emitters_.push_back(
        {-1, static_cast<std::uint32_t>(index), material.emission, material.two_sided});
    bounds.push_back(light);
}

std::optional<Emitters::Sample> Emitters::sample(const glm::vec3& position, const glm::vec3& n,
                                                 float choice, const glm::vec2& u) const {
    const auto chosen = tree_.choose(position, n, choice);
    if (!chosen) return std::nullopt;
    const Emitter& emitter = emitters_[chosen->light];
    const auto point = emitter.mesh < 0 ? sample_sphere(emitter, position, u)
                                        : sample_triangle(emitter, position, u);
    if (!point) return std::nullopt;
    const float cosine = glm::dot(n, point->wi);
    const float pdf = point->pdf * chosen->probability;
    // A float may overflow where an emitter is seen edge-on, and vanish where it is all but far.
    if (!(cosine > 0.f && pdf > 0.f && std::isfinite(pdf))) return std::nullopt;
    return Sample{point->target, emitter.Le, cosine, pdf};
}

std::optional<Emitters::Point> Emitters::sample_triangle(const Emitter& emitter,
                                                         const glm::vec3& position,
                                                         const glm::vec2& u) const {
    const WorldMesh& mesh = world_.meshes[static_cast<std::size_t>(emitter.mesh)];
    const glm::uvec3& t = mesh.triangles[emitter.primitive];
    // Evenly by area [Pharr et al. 2023, section 6.5.4].
    const float root = std::sqrt(u.x);
    const glm::vec3 point = (1.f - root) * mesh.positions[t.x] +
                            root * (1.f - u.y) * mesh.positions[t.y] +
                            root * u.y * mesh.positions[t.z];
    const glm::vec3 way = point - position;
    const float d2 = glm::dot(way, way);
    if (!(d2 > 0.f)) return std::nullopt;
    const glm::dvec3 normal = area_normal(mesh, emitter.primitive);
    const auto area = static_cast<float>(glm::length(normal) / 2.);
    const glm::vec3 wi = way / std::sqrt(d2);
    const float facing = -glm::dot(glm::vec3(glm::normalize(normal)), wi);
    if (facing == 0.f || (facing < 0.f && !emitter.two_sided)) return std::nullopt;
    return Point{point, wi, pdf_by_angle(d2, std::abs(facing), area)};
}

std::optional<Emitters::Point> Emitters::sample_sphere(const Emitter& emitter,
                                                       const glm::vec3& position,
                                                       const glm::vec2& u) const {
    const WorldSphere& sphere = world_.spheres[emitter.primitive];
    const bool inside = is_inside(sphere, position);
    if (inside != sphere.inward && !emitter.two_sided) return std::nullopt;
    if (!inside) {
        const SphereCone cone = sphere_cone(sphere.center - position, sphere.radius);
        const glm::vec3 wi = sample_cone(cone, u);
        return Point{position + distance_to_sphere(cone, sphere.radius, wi) * wi, wi,
                     1.f / cone.solid_angle()};
    }
    const float z = 1.f - 2.f * u.x;
    const float r = std::sqrt(glm::max(1.f - z * z, 0.f));
    const glm::vec3 outward(r * unit_circle(u.y), z);
    const glm::vec3 target = sphere.center + sphere.radius * outward;
    const glm::vec3 way = target - position;
    const float d2 = glm::dot(way, way);
    if (!(d2 > 0.f)) return std::nullopt;
    const glm::vec3 wi = way / std::sqrt(d2);
    const float facing = glm::dot(outward, wi);
    if (!(facing > 0.f)) return std::nullopt;
    return Point{target, wi, pdf_by_angle(d2, facing, area_of(sphere))};
}

float Emitters::pdf(const Hit& hit, const glm::vec3& position, const glm::vec3& n) const {
    const std::vector<std::uint32_t>& emitter_of = emitter_of_[hit.geometry];
    if (emitter_of.empty() || emitter_of[hit.primitive] == none) return 0.f;
    const std::uint32_t light = emitter_of[hit.primitive];
    const Emitter& emitter = emitters_[light];
    const float chosen = tree_.probability(light, position, n);
    const glm::vec3 way = hit.position - position;
    const float d2 = glm::dot(way, way);
    const float facing = std::abs(glm::dot(hit.ng, way)) / std::sqrt(d2);
    if (emitter.mesh < 0) {
        const WorldSphere& sphere = world_.spheres[emitter.primitive];
        if (is_inside(sphere, position)) {
            return chosen * pdf_by_angle(d2, facing, area_of(sphere));
        }
        return chosen / sphere_cone(sphere.center - position, sphere.radius).solid_angle();
    }
    const WorldMesh& mesh = world_.meshes[static_cast<std::size_t>(emitter.mesh)];
    const auto area = static_cast<float>(glm::length(area_normal(mesh, emitter.primitive)) / 2.);
    return chosen * pdf_by_angle(d2, facing, area);
}

}  // namespace plumbline::pathtracer
