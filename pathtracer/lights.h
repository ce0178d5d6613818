// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

#include "pathtracer/cone.h"
#include "pathtracer/sampler.h"
#include "scenes/effects.h"
#include "scenes/ray_tracer.h"

namespace plumbline::pathtracer {

/// Lights that a plain point light's code does not cover.
inline constexpr Effects special_lights =
    Effects{} | Effect::SphereLights | Effect::SpotLights | Effect::DirectionalLights;
inline constexpr Effects any_light = special_lights | Effect::PointLights;

constexpr bool has_any(Effects effects, Effects some) { return (effects.bits & some.bits) != 0; }

/// The irradiance that reaches a surface unless something lies between it and `target`.
struct SampledLight {
    glm::vec3 target;
    Spectrum E{0.f};  ///< W m^-2; an estimate for a light with size
};

/// Samples the sphere light `light`, seen from `position` on a surface of unit normal `n`, evenly
/// by solid angle. E is zero for a direction below the surface, and from inside the light.
inline SampledLight sample_sphere_light(const PointLight& light, const glm::vec3& position,
                                        const glm::vec3& n, const glm::vec2& u) {
    const glm::vec3 to_center = light.position - position;
    if (glm::dot(to_center, to_center) <= light.radius * light.radius) return {position};
    const SphereCone cone = sphere_cone(to_center, light.radius);
    const glm::vec3 wi = sample_cone(cone, u);
    const float cosine = glm::max(glm::dot(n, wi), 0.f);
    const Spectrum L =
        normal_irradiance(light, to_center) / (std::numbers::pi_v<float> * cone.sin2);
    return {position + distance_to_sphere(cone, light.radius, wi) * wi,
            L * (cosine * cone.solid_angle())};
}

/// Irradiance of `light` on the side `n` of the surface at `position`.
inline Spectrum point_light_irradiance(const EvenLight& light, const glm::vec3& position,
                                       const glm::vec3& n) {
    const glm::vec3 to_light = light.position - position;
    const float d_cosine = glm::max(glm::dot(n, to_light), 0.f);
    // Zero also from a light exactly on the surface, towards which there is no direction.
    const float d2 = d_cosine > 0.f ? glm::dot(to_light, to_light) : 1.f;
    return light.normal_irradiance(d2) * (d_cosine / std::sqrt(d2));
}

/// Irradiance of a point light or a spot on the side `n` of the surface at `position`.
inline SampledLight sample_point_light(const PointLight& light, const glm::vec3& position,
                                       const glm::vec3& n) {
    Spectrum E = point_light_irradiance(EvenLight(light), position, n);
    if (light.cone && E != Spectrum(0.f)) {
        E *= spot_attenuation(*light.cone, light.position - position);
    }
    return {light.position, E};
}

/// Irradiance of a directional light on the surface of unit normal `n` at `origin`, in a scene of
/// this reach.
inline SampledLight sample_directional_light(const DirectionalLight& light, float reach,
                                             const glm::vec3& origin, const glm::vec3& n) {
    const float cosine = glm::max(-glm::dot(n, light.direction), 0.f);
    return {origin - reach * light.direction, light.irradiance * cosine};
}

/// Calls add(sample) for each point, sphere and spot light, as it shines on the side `n` of the
/// surface at `position`. Draws numbers for lights with size alone.
template <Effects F, typename Add>
void sample_lights(const World& world, const glm::vec3& position, const glm::vec3& n,
                   Sampler& sampler, const Add& add) {
    for (const PointLight& light : world.lights) {
        if constexpr (has(F, Effect::SphereLights)) {
            if (light.radius > 0.f) {
                add(sample_sphere_light(light, position, n, sampler.next_2d()));
                continue;
            }
        }
        add(sample_point_light(light, position, n));
    }
}

}  // namespace plumbline::pathtracer
