// SPDX-License-Identifier: Apache-2.0
// What each step of the path tracer is worth: efficiency 1 / (relMSE x CPU time) of the same
// picture without any of them, and with one after the other.
#include <benchmark/benchmark.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <array>
#include <vector>

#include "pathtracer/estimate.h"
#include "pathtracer/kernels.h"
#include "pathtracer/wave.h"
#include "scenes/camera_rays.h"
#include "scenes/scene_files.h"

namespace plumbline::pathtracer {
namespace {

constexpr glm::ivec2 size(240, 136);
constexpr int batches = 4;
constexpr int spp = batches * Sampler::batch_size;

/// How a picture is made.
struct Way {
    const char* name;
    bool own_kernel;  ///< else one for all effects, but those of pictures and of many lights
    int packet_width;
    bool roulette;
    bool stratified;
};

/// Each with one step more than the one before. Paths without roulette stop where the series of a
/// furnace of albedo .73, the Cornell Box's brightest, has lost a millionth.
constexpr std::array ways{
    Way{"all effects, single rays, 44 bounces, independent samples", false, 1, false, false},
    Way{"+ own kernel", true, 1, false, false},
    Way{"+ packets", true, 8, false, false},
    Way{"+ Russian roulette", true, 8, true, false},
    Way{"+ stratified batches", true, 8, true, true},
};

World world_of(const char* name, int frame) {
    Scene scene = load_scene(name);
    scene.camera.width = size.x;
    scene.camera.height = size.y;
    return world_at(scene, frame);
}

PathOptions options_of(const Way& way) {
    PathOptions options;
    options.roulette = way.roulette;
    if (!way.roulette) options.max_scatterings = 45;
    return options;
}

/// The picture of `world`, each pixel's groups being independent samples or stratified batches.
template <Effects F>
std::vector<PixelEstimate> picture_of(const RayTracer& tracer, const Way& way) {
    const World& world = tracer.world();
    const CameraRays camera_rays(world.camera);
    const glm::vec3 forward = glm::normalize(world.camera.target - world.camera.eye);
    tbb::enumerable_thread_specific<Wave<F, RayTracer>> waves(
        [&] { return Wave<F, RayTracer>(tracer, options_of(way)); });
    std::vector<PixelEstimate> pixels(std::size_t(size.x) * std::size_t(size.y));
    constexpr int pixels_a_wave = 16;
    static_assert(size.x % pixels_a_wave == 0);
    tbb::parallel_for(0, size.x * size.y / pixels_a_wave, [&](int part) {
        Wave<F, RayTracer>& wave = waves.local();
        const auto first = std::size_t(part) * pixels_a_wave;
        for (std::size_t i = first; i < first + pixels_a_wave; ++i) {
            const glm::ivec2 at(int(i) % size.x, int(i) / size.x);
            for (int sample = 0; sample < spp; ++sample) {
                // The first of a batch of its own is independent of all others.
                const int index = way.stratified ? sample : sample * Sampler::batch_size;
                Sampler sampler(pixel_key(0, at.x, at.y), index);
                const glm::vec2 on_film = glm::vec2(at) + sampler.next_2d();
                wave.start(camera_rays.through(on_film.x, on_film.y), sampler);
            }
        }
        std::span<const Path> paths = wave.follow();
        const std::size_t group_size = way.stratified ? Sampler::batch_size : 1;
        for (std::size_t i = first; i < first + pixels_a_wave; ++i) {
            for (int group = 0; group < spp / int(group_size); ++group) {
                SampleSums sums;
                for (const Path& path : paths.first(group_size))
                    sums.add(path, world.camera.eye, forward);
                pixels[i].add_group(sums);
                paths = paths.subspan(group_size);
            }
        }
    });
    return pixels;
}

void render_step(benchmark::State& state) {
    static const World cornell_box = world_of("cornell-box", 0);
    static const World room_with_door = world_of("room-with-door", 350);
    const Way& way = ways.at(std::size_t(state.range(1)));
    const RayTracer tracer(state.range(0) == 0 ? cornell_box : room_with_door, way.packet_width);
    constexpr Effects own = Effects{} | Effect::PointLights;
    constexpr Effects all =
        any_light | Effect::Emission | Effect::EmitterSampling | Effect::Environment;
    double relmse = 0.;
    for (auto _ : state) {
        relmse = relmse_estimate(way.own_kernel ? picture_of<own>(tracer, way)
                                                : picture_of<all>(tracer, way));
    }
    state.SetLabel(way.name);
    state.counters["relMSE"] = relmse;
    state.counters["efficiency"] =
        benchmark::Counter(double(state.iterations()) / relmse, benchmark::Counter::kIsRate);
}

// Scene 0: cornell-box; 1: room-with-door at frame 350. Not in real time: efficiency is by CPU
// time.
BENCHMARK(render_step)
    ->ArgNames({"scene", "step"})
    ->ArgsProduct({{0, 1}, benchmark::CreateDenseRange(0, int(ways.size()) - 1, 1)})
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace plumbline::pathtracer
