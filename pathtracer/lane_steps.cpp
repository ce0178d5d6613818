// SPDX-License-Identifier: Apache-2.0
#include "pathtracer/lane_steps.h"

#include <numbers>

#include "pathtracer/hemisphere.h"
#include "scenes/wide.h"

namespace plumbline::pathtracer {

PLUMBLINE_WIDE void aim_camera(const CameraRays& camera, const glm::vec2& pixel,
                               SamplerLanes& samplers, RayLanes& rays) {
    const CameraRays through = camera;
    const glm::vec2 corner = pixel;
#pragma GCC ivdep
    for (std::size_t i = 0; i < rays.count; ++i) {
        Sampler sampler = samplers[i];
        const glm::vec2 at = corner + sampler.next_2d();
        samplers.set(i, sampler);
        rays.set(i, through.through(at.x, at.y));
    }
}

PLUMBLINE_WIDE void start_rays(const HitLanes& hits, Lanes3& origin) {
#pragma GCC ivdep
    for (std::size_t i = 0; i < hits.count; ++i) {
        origin.set(i, offset_origin(hits.position[i], hits.position_error[i], hits.n[i]));
    }
}

PLUMBLINE_WIDE void shine(EvenLight light, const HitLanes& hits, const Lanes3& beta, Lanes3& L) {
#pragma GCC ivdep
    for (std::size_t i = 0; i < hits.count; ++i) {
        const Spectrum f_beta = beta[i] * hits.albedo[i] * std::numbers::inv_pi_v<float>;
        L.set(i, f_beta * point_light_irradiance(light, hits.position[i], hits.n[i]));
    }
}

PLUMBLINE_WIDE void find_lit(std::size_t count, const Lanes3& L, Lanes<std::int32_t>& lit) {
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) {
        lit[i] = (L.x[i] != 0.f ? 1 : 0) | (L.y[i] != 0.f ? 1 : 0) | (L.z[i] != 0.f ? 1 : 0);
    }
}

PLUMBLINE_WIDE void find_seen(std::size_t count, const Lanes<std::int32_t>& hidden,
                              Lanes<std::int32_t>& seen) {
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) seen[i] = hidden[i] == 0 ? 1 : 0;
}

PLUMBLINE_WIDE void scatter(const HitLanes& hits, WalkLanes& walks) {
#pragma GCC ivdep
    for (std::size_t i = 0; i < hits.count; ++i) {
        Sampler sampler = walks.sampler[i];
        const glm::vec2 u = sampler.next_2d();
        walks.sampler.set(i, sampler);
        // Cosine-weighted sampling cancels f cos(theta) / pdf = (rho/pi) cos / (cos/pi) to rho.
        walks.rays.direction.set(i, sample_cosine_hemisphere(u, hits.n[i]));
        walks.beta.set(i, walks.beta[i] * hits.albedo[i]);
    }
}

PLUMBLINE_WIDE void find_alive(std::size_t count, const WalkLanes& walks,
                               Lanes<std::int32_t>& alive) {
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) alive[i] = max_component(walks.beta[i]) != 0.f ? 1 : 0;
}

PLUMBLINE_WIDE void play_roulette(const PathOptions& options, std::size_t count, WalkLanes& walks,
                                  Lanes<std::int32_t>& alive) {
    // Below 1, so that paths end even where nothing absorbs.
    constexpr float highest_survival = .95f;
    const float sure_throughput = options.sure_throughput;
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) {
        Sampler sampler = walks.sampler[i];
        const float u = sampler.next_1d();
        walks.sampler.set(i, sampler);
        const float survival =
            glm::min(highest_survival, max_component(walks.beta[i]) / sure_throughput);
        alive[i] &= u < survival ? 1 : 0;
        walks.beta.set(i, walks.beta[i] / survival);
    }
}

}  // namespace plumbline::pathtracer
