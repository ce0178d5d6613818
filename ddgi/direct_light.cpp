// SPDX-License-Identifier: Apache-2.0
#include "ddgi/direct_light.h"

#include <bit>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace plumbline::ddgi {
namespace {

/// A number of [0,1) that depends on every bit of a position: PCG's output permutation as a hash
/// [Jarzynski and Olano 2020].
float hashed(const glm::vec3& position, std::uint32_t salt) {
    std::uint32_t hash = salt;
    for (int axis = 0; axis < 3; ++axis) {
        std::uint32_t state = (hash ^ std::bit_cast<std::uint32_t>(position[axis])) * 747796405u;
        state += 2891336453u;
        const std::uint32_t word = ((state >> ((state >> 28) + 4u)) ^ state) * 277803737u;
        hash = (word >> 22) ^ word;
    }
    return static_cast<float>(hash >> 8) * 0x1p-24f;
}

/// Irradiance at a point from a light's ball, by rays evenly spread over the solid angle that it
/// fills: a golden-angle spiral, shifted and turned at random from point to point so that
/// neighbours' errors differ and average out.
DirectLight from_ball(const RayTracer& tracer, const PointLight& light, const glm::vec3& position,
                      const glm::vec3& n, int rays) {
    const glm::vec3 way = light.position - position;
    const float d2 = glm::dot(way, way);
    const float r2 = light.radius * light.radius;
    DirectLight result;
    if (d2 <= r2) return result;  // inside the ball, which shines outward
    const float cone_cosine = std::sqrt(1.f - r2 / d2);
    const float height_of_cap = r2 / d2 / (1.f + cone_cosine);  // 1 - cosine, without cancellation
    const Spectrum radiance = normal_irradiance(light, way) * (d2 / (glm::pi<float>() * r2));
    const glm::vec3 axis = way / std::sqrt(d2);
    const glm::vec3 helper = std::abs(axis.x) < .5f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    const glm::vec3 u = glm::normalize(glm::cross(helper, axis));
    const glm::vec3 v = glm::cross(axis, u);
    const float golden_angle = glm::pi<float>() * (3.f - std::sqrt(5.f));
    const float shift = hashed(position, 1u);
    const float turn = 2.f * glm::pi<float>() * hashed(position, 2u);
    float cosines = 0.f;
    for (int ray = 0; ray < rays; ++ray) {
        const float share = (static_cast<float>(ray) + shift) / static_cast<float>(rays);
        const float down = share * height_of_cap;
        const float sine = std::sqrt(down * (2.f - down));
        const float phi = turn + golden_angle * static_cast<float>(ray);
        const glm::vec3 direction =
            (1.f - down) * axis + sine * (std::cos(phi) * u + std::sin(phi) * v);
        const float cosine = glm::dot(n, direction);
        if (cosine <= 0.f) continue;
        ++result.shadow_rays;
        // To the ball's near side, as the rays to a point end at the point.
        const float along = glm::dot(way, direction);
        const float half_chord = std::sqrt(glm::max(along * along - (d2 - r2), 0.f));
        if (!tracer.occluded(position, position + (along - half_chord) * direction)) {
            cosines += cosine;
        }
    }
    const float solid_angle = 2.f * glm::pi<float>() * height_of_cap;
    result.irradiance = radiance * (solid_angle * cosines / static_cast<float>(rays));
    return result;
}

/// Of a point or a spot: seen whole or not at all, so that all its rays are the same.
DirectLight from_point(const RayTracer& tracer, const PointLight& light, const glm::vec3& position,
                       const glm::vec3& n, int rays) {
    const glm::vec3 way = light.position - position;
    const float height = glm::dot(n, way);
    DirectLight result;
    if (height <= 0.f) return result;
    const Spectrum E = normal_irradiance(light, way);
    if (light.cone && E == Spectrum(0.f)) return result;
    int arriving = 0;
    for (int ray = 0; ray < rays; ++ray) {
        if (!tracer.occluded(position, light.position)) ++arriving;
    }
    result.shadow_rays = static_cast<std::uint32_t>(rays);
    const float visibility = static_cast<float>(arriving) / static_cast<float>(rays);
    result.irradiance = visibility * height / glm::length(way) * E;
    return result;
}

DirectLight from_afar(const RayTracer& tracer, const DirectionalLight& light,
                      const glm::vec3& position, const glm::vec3& n) {
    DirectLight result;
    const float cosine = -glm::dot(n, light.direction);
    if (cosine <= 0.f) return result;
    result.shadow_rays = 1;
    if (!tracer.occluded(position, position - tracer.world().reach * light.direction)) {
        result.irradiance = cosine * light.irradiance;
    }
    return result;
}

}  // namespace

DirectLight direct_light(const RayTracer& tracer, const glm::vec3& position, const glm::vec3& n,
                         int rays) {
    DirectLight result;
    const auto add = [&](const DirectLight& light) {
        result.irradiance += light.irradiance;
        result.shadow_rays += light.shadow_rays;
    };
    for (const PointLight& light : tracer.world().lights) {
        const auto from = light.radius > 0.f ? from_ball : from_point;
        add(from(tracer, light, position, n, rays));
    }
    for (const DirectionalLight& light : tracer.world().directional_lights) {
        add(from_afar(tracer, light, position, n));
    }
    return result;
}

}  // namespace plumbline::ddgi
