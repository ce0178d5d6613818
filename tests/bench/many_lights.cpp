// SPDX-License-Identifier: Apache-2.0
// Efficiency, 1 / (relMSE x CPU time), against the number of lights: every light at every vertex,
// and one chosen by the tree.
#include <benchmark/benchmark.h>

#include <random>

#include "pathtracer/passes.h"
#include "pathtracer/simple_scenes.h"

namespace plumbline::pathtracer {
namespace {

constexpr int spp = 4 * Sampler::batch_size;

/// A hall 20 x 4 x 20 with nine pillars, and lights anywhere under its ceiling that together are as
/// strong whatever their number: of four, one falls off with nothing, one is a ball, one a spot.
Scene hall(std::int64_t lights) {
    Scene scene;
    scene.name = "hall";
    const int grey = add_material(scene, Spectrum(.6f));
    for (Quad wall : room_walls({grey, grey, grey, grey, grey, grey})) {
        const glm::vec3 half(10.f, 2.f, 10.f);
        wall = {wall.corner * half, wall.edge_u * half, wall.edge_v * half, grey};
        add_object(scene, wall);
    }
    for (int i = 0; i < 9; ++i) {
        const glm::vec3 foot(float(i % 3 - 1) * 6.f, -2.f, float(i / 3 - 1) * 6.f);
        add_object(scene, Box{foot - glm::vec3(.6f, 0.f, .6f),
                              foot + glm::vec3(.6f, 4.f, .6f),
                              {grey, grey, grey, grey, grey, grey}});
    }
    std::mt19937 random(1);
    std::uniform_real_distribution<float> uniform(0.f, 1.f);
    const auto between = [&](float low, float high) {
        return low + (high - low) * uniform(random);
    };
    for (std::int64_t i = 0; i < lights; ++i) {
        const glm::vec3 at(between(-9.5f, 9.5f), between(.8f, 1.8f), between(-9.5f, 9.5f));
        const float strength = 2.f * uniform(random) / float(lights);
        PointLight light = inverse_square(at, Spectrum(60.f * strength));
        if (i % 4 == 1) {
            light.falloff = Falloff::None;
            light.white_radiance = Spectrum(strength);
        }
        if (i % 4 == 2) light.radius = .15f;
        if (i % 4 == 3) light.cone = SpotCone{{0.f, -1.f, 0.f}, .3f, .9f};
        scene.lights.push_back(light);
    }
    scene.camera = {.eye = {-9.f, 0.f, 9.f},
                    .target = {0.f, -.6f, 0.f},
                    .vertical_fov = 1.f,
                    .width = 32,
                    .height = 18};
    return scene;
}

void lights(benchmark::State& state) {
    const World world = world_at(hall(state.range(0)), 0);
    const RayTracer tracer(world);
    const bool by_choice = state.range(1) != 0;
    const Effects every =
        Effects{} | Effect::PointLights | Effect::SphereLights | Effect::SpotLights;
    const Effects effects = by_choice ? every | Effect::LightChoice : every;
    Progress::silence();
    double relmse = 0.;
    for (auto _ : state) {
        Passes passes(tracer, effects, {}, 0);
        Progress progress("benchmark", passes.steps(spp));
        passes.add({spp, Sampler::batch_size}, progress);
        relmse = relmse_estimate(passes.pixels());
        state.counters["rays"] = double(passes.rays());
    }
    state.counters["relMSE"] = relmse;
    state.counters["efficiency"] =
        benchmark::Counter(double(state.iterations()) / relmse, benchmark::Counter::kIsRate);
}

BENCHMARK(lights)
    ->ArgNames({"lights", "choice"})
    ->ArgsProduct({{1, 2, 4, 6, 8, 12, 16, 32, 100, 1000, 10000}, {0, 1}})
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace plumbline::pathtracer
