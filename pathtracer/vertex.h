// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <numbers>
#include <vector>

#include "pathtracer/direct_light.h"
#include "pathtracer/hemisphere.h"
#include "pathtracer/path.h"
#include "pathtracer/sampler.h"
#include "scenes/effects.h"

namespace plumbline::pathtracer {

/// A path that is still followed: what its next ray carries.
struct Walk {
    Spectrum beta{1.f};  ///< path throughput: product of f cos(theta) / pdf
    Sampler sampler;
    std::uint32_t path;  ///< which of the paths under way
    LastVertex last{};   ///< known where emitters are aimed at
};

/// Radiance that counts for a path if nothing lies between two points.
struct LightSample {
    Spectrum L;
    std::uint32_t path;
};

/// Light samples of many paths, to be tested together for what lies between.
struct LightSamples {
    std::vector<Segment> segments;
    std::vector<LightSample> samples;  ///< one a segment

    void add(const Segment& segment, const LightSample& sample) {
        segments.push_back(segment);
        samples.push_back(sample);
    }
    void clear() {
        segments.clear();
        samples.clear();
    }
};

/// Adds to `samples` the radiance that the surface at `hit` scatters from lights and from what is
/// aimed at, seen from its side `n`; shadow rays start at `origin`.
template <Effects F>
void add_direct_light(const World& world, const PathOptions& options, const Hit& hit,
                      const glm::vec3& n, const glm::vec3& origin, Walk& walk,
                      LightSamples& samples) {
    const Spectrum f_beta = walk.beta * hit.albedo * std::numbers::inv_pi_v<float>;
    const auto add = [&](const SampledLight& light) {
        samples.add({origin, light.target}, {f_beta * light.E, walk.path});
    };
    sample_direct_light<F>(world, options, hit, n, origin, walk.sampler, add);
}

/// True if roulette lets the path of `walk` live on; its throughput then makes up for those ended.
inline bool survives_roulette(Walk& walk, const PathOptions& options) {
    // Below 1, so that paths end even where nothing absorbs.
    constexpr float highest_survival = .95f;
    const float survival =
        glm::min(highest_survival, max_component(walk.beta) / options.sure_throughput);
    if (walk.sampler.next_1d() >= survival) return false;
    walk.beta /= survival;
    return true;
}

/// What happens at `hit`, where the ray `ray` of `walk` ends after `scatterings` scatterings: adds
/// emission and environment to `path`, light samples to `samples`, and leaves in `ray` and `walk`
/// the way on. False if the path ends here.
///
/// Unbiased for the radiance that is scattered at most `options.max_scatterings` times.
/// Lights are sampled at every surface, emitters with Effect::EmitterSampling, and the environment
/// with Effect::EnvironmentImage; emission and environment count where a path meets them. Code for
/// an effect outside F is compiled out; F must cover effects_of() the scene.
template <Effects F>
bool shade_vertex(const World& world, const PathOptions& options, int scatterings,
                  const std::optional<Hit>& hit, Ray& ray, Walk& walk, Path& path,
                  LightSamples& samples) {
    constexpr bool surfaces_or_sky_shine = has(F, Effect::Emission) || has(F, Effect::Environment);
    if (!hit) {
        if constexpr (has(F, Effect::Environment)) {
            path.add(scatterings, walk.beta * met_environment<F>(world, options, scatterings,
                                                                 walk.last, ray.direction));
        }
        return false;
    }
    const Material& material = world.materials[static_cast<std::size_t>(hit->material)];
    if (hit->back && !material.two_sided) return false;  // the back is black

    if constexpr (has(F, Effect::Emission)) {
        path.add(scatterings, walk.beta * met_emission<F>(material.emission, options, scatterings,
                                                          walk.last, *hit));
    }
    if (scatterings == options.max_scatterings) return false;
    const glm::vec3 n = hit->n();
    const glm::vec3 origin = offset_origin(*hit, n);
    if constexpr (has_any(F, sampled)) {
        add_direct_light<F>(world, options, *hit, n, origin, walk, samples);
    }
    // Without these, nothing that the last ray could meet would count.
    if (!surfaces_or_sky_shine && scatterings + 1 == options.max_scatterings) return false;

    // Cosine-weighted sampling cancels f cos(theta) / pdf = (rho/pi) cos / (cos/pi) to rho.
    ray = {origin, sample_cosine_hemisphere(walk.sampler.next_2d(), n)};
    if constexpr (has_any(F, aimed_at)) {
        walk.last = {hit->position, n, pdf_cosine_hemisphere(glm::dot(n, ray.direction))};
    }
    walk.beta *= hit->albedo;
    if (max_component(walk.beta) == 0.f) return false;
    if (!options.roulette || scatterings + 1 < options.roulette_start) return true;
    return survives_roulette(walk, options);
}

}  // namespace plumbline::pathtracer
