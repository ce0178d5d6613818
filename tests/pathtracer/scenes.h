// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "pathtracer/estimate.h"
#include "pathtracer/simple_scenes.h"
#include "pathtracer/wave.h"
#include "scenes/world.h"

namespace plumbline::pathtracer::test {

inline constexpr Effects all_effects = any_light | Effect::Emission | Effect::EmitterSampling |
                                       Effect::Environment | Effect::EnvironmentImage |
                                       Effect::LightChoice;

using pathtracer::add_material;
using pathtracer::add_object;
using pathtracer::inverse_square;
using pathtracer::mixed_room;
using pathtracer::room_walls;

/// Estimates the radiance along `ray` from whole batches of paths.
inline PixelEstimate estimate_along(const RayTracer& tracer, const Ray& ray, int batches,
                                    const PathOptions& options, std::uint64_t seed = 0) {
    PixelEstimate estimate;
    const std::uint64_t key = pixel_key(seed, 0, 0);
    Wave<all_effects, RayTracer> wave(tracer, options);
    for (int batch = 0; batch < batches; ++batch) {
        for (int i = 0; i < Sampler::batch_size; ++i) {
            wave.start(ray, Sampler(key, batch * Sampler::batch_size + i));
        }
        SampleSums group;
        for (const Path& path : wave.follow()) group.add(path, ray.origin, ray.direction);
        estimate.add_group(group);
    }
    return estimate;
}

/// Paths of exactly `max_bounces` indirect bounces.
inline PathOptions bounces(int max_bounces) {
    return {.max_scatterings = max_bounces + 1, .roulette = false};
}

/// Deviation of the channel `c` of the mean radiance from `expected`, in standard errors.
inline double radiance_z(const PixelEstimate& estimate, int c, double expected) {
    const double mean = estimate.sums.radiance()[c] / estimate.sums.samples;
    return (mean - expected) / std::sqrt(estimate.radiance_variance()[c]);
}

}  // namespace plumbline::pathtracer::test
