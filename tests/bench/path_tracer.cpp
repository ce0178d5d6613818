// SPDX-License-Identifier: Apache-2.0
// How near the path tracer comes to its limit: the rays of a render, traced by the render itself
// and replayed through bare Embree. (replay time) / (render time) is the share of the render that
// no kernel could do without. Also its efficiency, 1 / (variance x time).
#include <benchmark/benchmark.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <array>
#include <string>
#include <vector>

#include "pathtracer/kernels.h"
#include "pathtracer/passes.h"
#include "scenes/scene_files.h"
#include "tests/bench/embree_replay.h"

namespace plumbline::pathtracer {
namespace {

constexpr int width = 240;
constexpr int height = 136;
constexpr int spp = 2 * Sampler::batch_size;

enum Kind { Camera, Bounce, Shadow };

/// The rays that a render asked for, by kind, in the order in which it asked.
using Queries = std::array<std::vector<Ray>, 3>;

/// Answers like the RayTracer it stands for, and keeps what it was asked.
class RecordingTracer {
 public:
    RecordingTracer(const RayTracer& tracer, Queries& queries)
        : tracer_(tracer), queries_(queries) {}
    void intersect(const RayLanes& rays, BackFaces back_faces, Coherence coherence,
                   HitLanes& hits) const {
        auto& kept = queries_[back_faces == BackFaces::Cull ? Camera : Bounce];
        for (std::size_t i = 0; i < rays.count; ++i) kept.push_back(rays[i]);
        tracer_.intersect(rays, back_faces, coherence, hits);
    }
    void occluded(const SegmentLanes& segments, Lanes<std::int32_t>& hidden) const {
        for (std::size_t i = 0; i < segments.count; ++i) {
            const auto [a, b] = segments[i];
            queries_[Shadow].push_back({a, b - a, 1.f});
        }
        tracer_.occluded(segments, hidden);
    }
    const World& world() const { return tracer_.world(); }

 private:
    const RayTracer& tracer_;
    Queries& queries_;
};

std::string names_of(Effects effects) {
    constexpr std::array names{"point",       "emission",    "environment", "sphere",
                               "spot",        "directional", "aim emitter", "environment image",
                               "light choice"};
    std::string all;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if ((effects.bits >> i & 1u) == 0) continue;
        all += (all.empty() ? "" : ", ") + std::string(names[i]);
    }
    return all;
}

/// A scene ready to render, and the rays that rendering it takes.
struct Workload {
    World world;
    Effects effects;
    RayTracer tracer;
    Queries queries;

    Workload(Scene scene, int frame)
        : world(world_at(sized(scene), frame)), effects(effects_of(scene)), tracer(world) {
        const CameraRays camera_rays(world.camera);
        const RecordingTracer recorder(tracer, queries);
        Wave<Effects{} | Effect::PointLights, RecordingTracer> wave(recorder, PathOptions{});
        constexpr int wave_size = 1024;
        static_assert(width * height * spp % wave_size == 0);
        for (int i = 0; i < width * height * spp; ++i) {
            const int x = i / spp % width;
            const int y = i / spp / width;
            Sampler sampler(pixel_key(0, x, y), i % spp);
            const glm::vec2 at = glm::vec2(x, y) + sampler.next_2d();
            wave.start(camera_rays.through(at.x, at.y), sampler);
            if ((i + 1) % wave_size == 0) wave.follow();
        }
    }

    std::size_t rays() const {
        return queries[Camera].size() + queries[Bounce].size() + queries[Shadow].size();
    }

 private:
    static const Scene& sized(Scene& scene) {
        scene.camera.width = width;
        scene.camera.height = height;
        return scene;
    }
};

const Workload& workload(std::int64_t index) {
    static const Workload cornell_box(load_scene("cornell-box"), 0);
    static const Workload room_with_door(load_scene("room-with-door"), 350);
    return index == 0 ? cornell_box : room_with_door;
}

void count_rays(benchmark::State& state, std::size_t rays_an_iteration) {
    state.counters["rays/s"] = benchmark::Counter(
        double(state.iterations()) * double(rays_an_iteration), benchmark::Counter::kIsRate);
}

void render(benchmark::State& state) {
    const Workload& work = workload(state.range(0));
    Progress::silence();
    std::uint64_t rays = 0;
    double relmse = 0.;
    for (auto _ : state) {
        Passes passes(work.tracer, work.effects, {}, 0);
        Progress progress("benchmark", passes.steps(spp));
        passes.add({spp, Sampler::batch_size}, progress);
        rays = passes.rays();
        relmse = relmse_estimate(passes.pixels());
    }
    count_rays(state, rays);
    state.counters["efficiency"] =
        benchmark::Counter(double(state.iterations()) / relmse, benchmark::Counter::kIsRate);
}

/// Four times as many samples, after the first quarter all even or shared out.
void adaptive(benchmark::State& state) {
    const Workload& work = workload(state.range(0));
    const Sampling sampling = state.range(1) == 0 ? Sampling::Even : Sampling::Adaptive;
    Progress::silence();
    double relmse = 0.;
    for (auto _ : state) {
        Passes passes(work.tracer, work.effects, {}, 0, {}, sampling);
        Progress progress("benchmark", passes.steps(4 * spp));
        passes.add({spp, Sampler::batch_size}, progress);
        if (sampling == Sampling::Adaptive) passes.share_out();
        passes.add({4 * spp, Sampler::batch_size}, progress);
        relmse = relmse_estimate(passes.pixels());
    }
    state.counters["efficiency"] =
        benchmark::Counter(double(state.iterations()) / relmse, benchmark::Counter::kIsRate);
}

/// A render by a kernel that may do more than the scene calls for: what it takes longer than
/// the scene's own is the cost of effects that the scene lacks, were they not compiled out.
void kernel(benchmark::State& state) {
    const Workload& work = workload(state.range(0));
    const Effects effects = kernels[std::size_t(state.range(1))];
    Progress::silence();
    for (auto _ : state) {
        Passes passes(work.tracer, effects, {}, 0);
        Progress progress("benchmark", passes.steps(Sampler::batch_size));
        passes.add({Sampler::batch_size, Sampler::batch_size}, progress);
    }
    state.SetLabel(names_of(effects));
}

/// Replays one kind of rays, N at a time, on all threads.
template <int N>
void replay_packets(benchmark::State& state) {
    const Workload& work = workload(state.range(0));
    const auto kind = static_cast<Kind>(state.range(1));
    const bench::BareEmbree embree(work.world);
    const std::span<const Ray> rays = work.queries[kind];
    constexpr std::size_t grain = 4096;
    for (auto _ : state) {
        tbb::parallel_for(
            tbb::blocked_range<std::size_t>(0, rays.size(), grain), [&](const auto& range) {
                const auto part = rays.subspan(range.begin(), range.size());
                benchmark::DoNotOptimize(embree.trace<N>(part, kind == Shadow, kind == Camera));
            });
    }
    count_rays(state, rays.size());
}

void replay(benchmark::State& state) {
    switch (state.range(2)) {
        case 1:
            return replay_packets<1>(state);
        case 4:
            return replay_packets<4>(state);
        case 8:
            return replay_packets<8>(state);
        default:
            return replay_packets<16>(state);
    }
}

// Scene 0: cornell-box; 1: room-with-door at frame 350. Kind 0: camera; 1: bounce; 2: shadow rays.
BENCHMARK(render)
    ->ArgNames({"scene"})
    ->Arg(0)
    ->Arg(1)
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(adaptive)
    ->ArgNames({"scene", "adaptive"})
    ->ArgsProduct({{0, 1}, {0, 1}})
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(kernel)
    ->ArgNames({"scene", "kernel"})
    ->Apply([](auto* benchmark) {
        for (int scene = 0; scene < 2; ++scene) {
            for (std::size_t i = 0; i < kernels.size(); ++i) {
                if (covers(kernels[i], Effects{} | Effect::PointLights))
                    benchmark->Args({scene, int(i)});
            }
        }
    }) -> UseRealTime() -> MeasureProcessCPUTime() -> Unit(benchmark::kMillisecond);
BENCHMARK(replay)
    ->ArgNames({"scene", "kind", "width"})
    ->ArgsProduct({{0, 1}, {Camera, Bounce, Shadow}, {1, 4, 8, 16}})
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace plumbline::pathtracer
