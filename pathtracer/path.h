// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <numbers>
#include <optional>

#include "pathtracer/hemisphere.h"
#include "pathtracer/sampler.h"
#include "scenes/effects.h"
#include "scenes/ray_tracer.h"

namespace plumbline::pathtracer {

/// Which paths are followed, and how far.
struct PathOptions {
    int max_scatterings = std::numeric_limits<int>::max();
    /// Ends paths at random; without it, every path runs to max_scatterings or out of the scene.
    bool roulette = true;
    /// Scatterings before roulette may end a path. This and `sure_throughput` gave the lowest
    /// variance times rays of many settings tried on the library's cornell-box and room-with-door.
    int roulette_start = 5;
    /// Throughput below which roulette becomes likelier to end a path the less it carries.
    float sure_throughput = .25f;
};

/// One path's estimate of the radiance along a camera ray, W m^-2 sr^-1, split by how often the
/// light was scattered on its way, and the first surface met.
struct Path {
    Spectrum direct{0.f};    ///< scattered once at most
    Spectrum bounce1{0.f};   ///< scattered twice
    Spectrum indirect{0.f};  ///< scattered twice or more
    std::optional<Hit> surface;
    unsigned rays = 0;  ///< camera, bounce and shadow rays

    void add(int scatterings, const Spectrum& L) {
        if (scatterings <= 1) {
            direct += L;
            return;
        }
        indirect += L;
        if (scatterings == 2) bounce1 += L;
    }
};

/// Radiance that the surface at `hit` scatters from the point lights, seen from its side n();
/// shadow rays start at `origin`.
template <typename Tracer>
Spectrum scattered_from_lights(const Tracer& tracer, const Hit& hit, const glm::vec3& origin,
                               unsigned& rays) {
    const glm::vec3 n = hit.n();
    Spectrum E(0.f);
    for (const PointLight& light : tracer.world().lights) {
        const glm::vec3 to_light = light.position - hit.position;
        const float d_cosine = glm::dot(n, to_light);
        // Also leaves out a light exactly on the surface, towards which there is no direction.
        if (d_cosine <= 0.f) continue;
        ++rays;
        if (tracer.occluded(origin, light.position)) continue;
        const float d2 = glm::dot(to_light, to_light);
        E += normal_irradiance(light, d2) * (d_cosine / std::sqrt(d2));
    }
    return hit.albedo * std::numbers::inv_pi_v<float> * E;
}

/// Follows one path from the camera ray `ray`, with an unbiased estimate of the radiance that is
/// scattered at most `options.max_scatterings` times. Point lights are sampled at every surface;
/// emission and environment count where a path meets them.
///
/// Code for an effect outside F is compiled out; F must cover effects_of() the scene. `tracer` is a
/// RayTracer, or answers like one.
template <Effects F, typename Tracer>
Path trace_path(const Tracer& tracer, Ray ray, Sampler& sampler, const PathOptions& options) {
    constexpr bool surfaces_or_sky_shine = has(F, Effect::Emission) || has(F, Effect::Environment);
    const World& world = tracer.world();
    Path path;
    Spectrum beta(1.f);  // path throughput: product of f cos(theta) / pdf
    for (int scatterings = 0;; ++scatterings) {
        ++path.rays;
        const std::optional<Hit> hit =
            tracer.intersect(ray, scatterings == 0 ? BackFaces::Cull : BackFaces::Hit);
        if (!hit) {
            if constexpr (has(F, Effect::Environment)) {
                path.add(scatterings, beta * world.environment);
            }
            return path;
        }
        if (scatterings == 0) path.surface = hit;
        const Material& material = world.materials[static_cast<std::size_t>(hit->material)];
        if (hit->back && !material.two_sided) return path;  // the back is black

        if constexpr (has(F, Effect::Emission)) path.add(scatterings, beta * material.emission);
        if (scatterings == options.max_scatterings) return path;
        // Cosine-weighted sampling cancels f cos(theta) / pdf = (rho/pi) cos / (cos/pi) to rho.
        // Drawn ahead of the shadow rays, whose traversal hides how long it takes.
        const glm::vec3 n = hit->n();
        const glm::vec3 origin = offset_origin(*hit, n);
        const glm::vec3 wi = sample_cosine_hemisphere(sampler.next_2d(), n);

        if constexpr (has(F, Effect::PointLights)) {
            path.add(scatterings + 1,
                     beta * scattered_from_lights(tracer, *hit, origin, path.rays));
        }
        // Without these, nothing that the last ray could meet would count.
        if (!surfaces_or_sky_shine && scatterings + 1 == options.max_scatterings) return path;

        beta *= hit->albedo;
        if (max_component(beta) == 0.f) return path;
        if (options.roulette && scatterings + 1 >= options.roulette_start) {
            // Below 1, so that paths end even where nothing absorbs.
            constexpr float highest_survival = .95f;
            const float survival =
                glm::min(highest_survival, max_component(beta) / options.sure_throughput);
            if (sampler.next_1d() >= survival) return path;
            beta /= survival;
        }
        ray = {origin, wi};
    }
}

}  // namespace plumbline::pathtracer
