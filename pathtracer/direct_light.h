// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "pathtracer/hemisphere.h"
#include "pathtracer/light_choice.h"
#include "pathtracer/lights.h"
#include "pathtracer/path_options.h"

namespace plumbline::pathtracer {

/// What is aimed at, and met by chance too.
inline constexpr Effects aimed_at = Effects{} | Effect::EmitterSampling | Effect::EnvironmentImage;
/// What shadow rays are traced for.
inline constexpr Effects sampled = any_light | aimed_at;
/// Whose samples depend on a path's own numbers, so that each path draws them by itself.
inline constexpr Effects drawn_singly = special_lights | aimed_at | Effect::LightChoice;

/// The share of one technique, of density `pdf`, in the light that another of density `other` finds
/// too: what each finds, weighted so, adds up to all light.
inline float balance_heuristic(float pdf, float other) { return pdf / (pdf + other); }

/// How a path came to its present vertex: the last one's position and surface normal, and the
/// density of its direction by solid angle.
struct LastVertex {
    glm::vec3 position;
    glm::vec3 n;
    float pdf;
};

/// The share of a path that runs into light by itself, where aiming has the density `aiming`.
inline float share_of_meeting(Techniques techniques, const LastVertex& last, float aiming) {
    if (techniques == Techniques::Both) return balance_heuristic(last.pdf, aiming);
    return techniques == Techniques::MeetingOnly ? 1.f : 0.f;
}

/// Irradiance of radiance `L` from a direction of this cosine that was aimed at with density `pdf`,
/// times the share of aiming in it.
inline Spectrum aimed_irradiance(Techniques techniques, const Spectrum& L, float cosine,
                                 float pdf) {
    if (techniques == Techniques::MeetingOnly) return Spectrum(0.f);
    const float other = techniques == Techniques::Both ? pdf_cosine_hemisphere(cosine) : 0.f;
    // L cos / pdf, times the balance heuristic's pdf / (pdf + other).
    return L * (cosine / (pdf + other));
}

/// One of `lights`, over the probability of choosing it. Draws as many numbers for any light, so
/// that what follows stays stratified.
inline SampledLight sample_chosen_light(const LightChoice& lights, const glm::vec3& position,
                                        const glm::vec3& n, Sampler& sampler) {
    const float choice = sampler.next_1d();
    const glm::vec2 u = sampler.next_2d();
    const auto chosen = lights.choose(position, n, choice);
    if (!chosen) return {};
    const PointLight& light = *chosen->light;
    SampledLight sample = light.radius > 0.f ? sample_sphere_light(light, position, n, u)
                                             : sample_point_light(light, position, n);
    sample.E /= chosen->probability;
    return sample;
}

/// Aims at an emitter from `position` on a surface of unit normal `n`. Draws numbers if there are
/// emitters.
inline SampledLight sample_emitters(const PathOptions& options, const glm::vec3& position,
                                    const glm::vec3& n, Sampler& sampler) {
    if (options.emitters == nullptr) return {};
    const float choice = sampler.next_1d();
    const auto sample = options.emitters->sample(position, n, choice, sampler.next_2d());
    if (!sample) return {};
    return {sample->target,
            aimed_irradiance(options.techniques, sample->Le, sample->cosine, sample->pdf)};
}

/// Aims at the environment from `origin` on a surface of unit normal `n`, in a scene of this reach.
/// Draws numbers if there is a picture of it.
inline SampledLight sample_environment(const PathOptions& options, float reach,
                                       const glm::vec3& origin, const glm::vec3& n,
                                       Sampler& sampler) {
    if (options.environment == nullptr) return {};
    const EnvironmentMap::Sample sample = options.environment->sample(sampler.next_2d());
    const float cosine = glm::dot(n, sample.wi);
    if (!(cosine > 0.f && sample.pdf > 0.f)) return {};
    return {origin + reach * sample.wi,
            aimed_irradiance(options.techniques, sample.L, cosine, sample.pdf)};
}

/// Radiance of the environment that counts for a path that leaves along `wi` after `scatterings`.
template <Effects F>
Spectrum met_environment(const World& world, const PathOptions& options, int scatterings,
                         const LastVertex& last, const glm::vec3& wi) {
    if constexpr (has(F, Effect::EnvironmentImage)) {
        const Spectrum L = environment_radiance(world, wi);
        if (scatterings == 0 || options.environment == nullptr || L == Spectrum(0.f)) return L;
        return L * share_of_meeting(options.techniques, last, options.environment->pdf(wi));
    } else {
        return world.environment;
    }
}

/// Radiance of the surface at `hit`, of this emission, that counts for a path that met it after
/// `scatterings`.
template <Effects F>
Spectrum met_emission(const Spectrum& Le, const PathOptions& options, int scatterings,
                      const LastVertex& last, const Hit& hit) {
    if constexpr (has(F, Effect::EmitterSampling)) {
        if (scatterings > 0 && options.emitters != nullptr && Le != Spectrum(0.f)) {
            const float aiming = options.emitters->pdf(hit, last.position, last.n);
            return Le * share_of_meeting(options.techniques, last, aiming);
        }
    }
    return Le;
}

/// Calls add(sample) for each light, or the one chosen, that shines on the side `n` of the surface
/// at `position`, and for what is aimed at; shadow rays start at `origin`.
template <Effects F, typename Add>
void sample_direct_light(const World& world, const PathOptions& options, const glm::vec3& position,
                         const glm::vec3& n, const glm::vec3& origin, Sampler& sampler,
                         const Add& add) {
    const auto add_lit = [&](const SampledLight& sample) {
        if (sample.E != Spectrum(0.f)) add(sample);
    };
    const bool by_choice = has(F, Effect::LightChoice) && options.lights != nullptr;
    if constexpr (has(F, Effect::LightChoice)) {
        if (by_choice) add_lit(sample_chosen_light(*options.lights, position, n, sampler));
    }
    if constexpr (has_any(F, any_light)) {
        if (!by_choice) sample_lights<F>(world, position, n, sampler, add_lit);
    }
    if constexpr (has(F, Effect::DirectionalLights)) {
        for (const DirectionalLight& light : world.directional_lights) {
            add_lit(sample_directional_light(light, world.reach, origin, n));
        }
    }
    if constexpr (has(F, Effect::EmitterSampling)) {
        add_lit(sample_emitters(options, position, n, sampler));
    }
    if constexpr (has(F, Effect::EnvironmentImage)) {
        add_lit(sample_environment(options, world.reach, origin, n, sampler));
    }
}

}  // namespace plumbline::pathtracer
