// SPDX-License-Identifier: Apache-2.0
// What a frame costs the probes while objects move, with surfels kept and with all placed afresh.
#include <benchmark/benchmark.h>

#include <array>

#include "ddgi/volume.h"
#include "scenes/scene_files.h"

namespace plumbline::ddgi {
namespace {

constexpr std::array scene_names = {"cornell-box", "room-with-door"};
constexpr std::array model_names = {"conserving", "thesis"};
/// Both scenes move throughout these.
constexpr int first_frame = 210;
constexpr int last_frame = 340;

/// Plays the moving frames forth and back, one an iteration.
void probe_update(benchmark::State& state) {
    const Scene scene = load_scene(scene_names.at(std::size_t(state.range(0))));
    DdgiOptions options;
    options.model = model_names.at(std::size_t(state.range(1)));
    options.cache = state.range(2) != 0;
    ProbeVolume volume(scene, options);
    volume.move_to(first_frame);
    volume.update();
    StepTimes steps;
    double replaced = 0., shadow_rays = 0.;
    int frame = first_frame;
    int step = 1;
    for (auto _ : state) {
        if (frame + step > last_frame || frame + step < first_frame) step = -step;
        volume.move_to(frame += step);
        volume.update();
        steps += volume.figures().steps;
        replaced += double(volume.figures().replaced);
        shadow_rays += double(volume.figures().surfel_shadow_rays);
    }
    const auto mean = [](double sum) {
        return benchmark::Counter(sum, benchmark::Counter::kAvgIterations);
    };
    for (const auto& [name, ms] : timed_steps) state.counters[name] = mean(steps.*ms);
    state.counters["replaced"] = mean(replaced);
    state.counters["shadow_rays"] = mean(shadow_rays);
}

// Scene 0: cornell-box; 1: room-with-door. Model 0: conserving; 1: thesis.
BENCHMARK(probe_update)
    ->ArgNames({"scene", "model", "cache"})
    ->ArgsProduct({{0, 1}, {0, 1}, {0, 1}})
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace plumbline::ddgi
