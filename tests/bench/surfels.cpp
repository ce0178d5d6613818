// SPDX-License-Identifier: Apache-2.0
// How near the probes come to their limits: placing and lighting all surfels against the same rays
// replayed through bare Embree, and the look-up of probe light against the formula ray by ray.
#include <benchmark/benchmark.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "ddgi/direct_light.h"
#include "ddgi/ray_gather.h"
#include "ddgi/volume.h"
#include "scenes/scene_files.h"
#include "tests/bench/embree_replay.h"

namespace plumbline::ddgi {
namespace {

enum Kind { Place, See, Light };
/// Of placing and lighting: rays put into lanes, the same traced and made hits of, with backs
/// culled and ties broken; planes taken in, probes seen by them and by rays alone; light measured.
enum Part { SetUp, Hits, CulledHits, Planes, SeenByPlanes, SeenByRays, Lit };

constexpr std::size_t grain = 4096;

/// A scene's surfels, and the rays that placing and lighting them takes, by kind.
struct SurfelWork {
    World world;
    RayTracer tracer;
    SurfelCache cache;
    std::array<std::vector<Ray>, 3> rays;
    std::vector<glm::vec3> x, n;  ///< of the surfels that are on surfaces

    SurfelWork(const Scene& scene, int frame)
        : world(world_at(scene, frame)),
          tracer(world),
          cache(probe_grid(scene), sphere_pattern(64, true), Reach::FirstSurface,
                ProbeWeights::Visibility) {
        cache.rebuild(tracer);
        const Surfels& surfels = cache.surfels();
        for (std::size_t i = 0; i < surfels.size(); ++i) {
            const auto probe = std::uint32_t(i / std::size_t(surfels.per_probe));
            rays[Place].push_back({probe_position(cache.grid(), probe), surfels.direction[i]});
            if (!surfels.hit(i)) continue;
            x.push_back(surfels.place[i].position);
            n.push_back(surfels.place[i].n);
            add_ways(x.back(), n.back());
        }
    }

    std::size_t ray_count() const {
        return rays[Place].size() + rays[See].size() + rays[Light].size();
    }

 private:
    void add_ways(const glm::vec3& from, const glm::vec3& normal) {
        const auto add = [&](Kind kind, const glm::vec3& end) {
            const glm::vec3 way = end - from;
            if (glm::dot(way, normal) > 0.f) rays[kind].push_back({from, way, 1.f});
        };
        const ProbeNeighbours around = probe_neighbours(cache.grid(), from);
        for (std::size_t k = 0; k < around.probe.size(); ++k) {
            if (around.weight[k] != 0.f) add(See, probe_position(cache.grid(), around.probe[k]));
        }
        for (const PointLight& light : world.lights) add(Light, light.position);
    }
};

SurfelWork& surfel_work(std::int64_t index) {
    static SurfelWork cornell_box(load_scene("cornell-box"), 0);
    static SurfelWork room_with_door(load_scene("room-with-door"), 350);
    return index == 0 ? cornell_box : room_with_door;
}

void count_rate(benchmark::State& state, const char* what, std::size_t an_iteration) {
    state.counters[what] = benchmark::Counter(double(state.iterations()) * double(an_iteration),
                                              benchmark::Counter::kIsRate);
}

void place_and_light(benchmark::State& state) {
    SurfelWork& work = surfel_work(state.range(0));
    for (auto _ : state) work.cache.rebuild(work.tracer);
    count_rate(state, "surfels/s", work.cache.surfels().size());
    count_rate(state, "rays/s", work.ray_count());
}

template <int N>
void replay_surfel_rays_in(benchmark::State& state) {
    const SurfelWork& work = surfel_work(state.range(0));
    const auto kind = Kind(state.range(1));
    const bench::BareEmbree embree(work.world);
    const std::span<const Ray> rays = work.rays[kind];
    for (auto _ : state) {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, rays.size(), grain),
                          [&](const auto& range) {
                              const auto part = rays.subspan(range.begin(), range.size());
                              benchmark::DoNotOptimize(embree.trace<N>(part, kind != Place, false));
                          });
    }
    count_rate(state, "rays/s", rays.size());
}

void replay_surfel_rays(benchmark::State& state) {
    switch (state.range(2)) {
        case 1:
            return replay_surfel_rays_in<1>(state);
        case 4:
            return replay_surfel_rays_in<4>(state);
        default:
            return replay_surfel_rays_in<8>(state);
    }
}

/// Calls body(first, size) for all of `count`, in parallel.
template <typename Body>
void in_grains(std::size_t count, const Body& body) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                      [&](const auto& range) { body(range.begin(), range.size()); });
}

void put_in_lanes(std::span<const Ray> rays, RayLanes& lanes) {
    lanes.count = 0;
    for (const Ray& ray : rays) lanes.push(ray);
}

void trace_in_lanes(const SurfelWork& work, Part part) {
    in_grains(work.rays[Place].size(), [&](std::size_t begin, std::size_t size) {
        RayLanes lanes;
        HitLanes hits;
        for (std::size_t first = begin; first < begin + size; first += plumbline::lane_count) {
            const std::size_t count = std::min(plumbline::lane_count, begin + size - first);
            put_in_lanes(std::span(work.rays[Place]).subspan(first, count), lanes);
            benchmark::DoNotOptimize(&lanes);
            benchmark::ClobberMemory();
            if (part == SetUp) continue;
            work.tracer.intersect(lanes, part == Hits ? BackFaces::Hit : BackFaces::Cull,
                                  Coherence::Incoherent, hits);
            benchmark::DoNotOptimize(&hits);
        }
    });
}

void see_probes(const SurfelWork& work, const CellPlanes& planes) {
    in_grains(work.x.size(), [&](std::size_t begin, std::size_t size) {
        std::array<std::uint8_t, grain> seen;
        seen_probes(work.tracer, work.cache.grid(), planes, std::span(work.x).subspan(begin, size),
                    std::span(work.n).subspan(begin, size), std::span(seen).first(size));
        benchmark::DoNotOptimize(&seen);
    });
}

void light_surfels(const SurfelWork& work) {
    in_grains(work.x.size(), [&](std::size_t begin, std::size_t size) {
        std::array<DirectLight, grain> light;
        direct_light(work.tracer, std::span(work.x).subspan(begin, size),
                     std::span(work.n).subspan(begin, size), std::span(light).first(size));
        benchmark::DoNotOptimize(&light);
    });
}

void part_of_surfels(benchmark::State& state) {
    const SurfelWork& work = surfel_work(state.range(0));
    const auto part = Part(state.range(1));
    World ball;  // in every cell, so that planes tell nothing
    ball.spheres.push_back({0, glm::vec3(0.f), 1e6f, false, 0});
    CellPlanes planes(work.cache.grid());
    planes.take(part == SeenByRays ? ball : work.world);
    for (auto _ : state) {
        if (part <= CulledHits) trace_in_lanes(work, part);
        if (part == Planes) planes.take(work.world);
        if (part == SeenByPlanes || part == SeenByRays) see_probes(work, planes);
        if (part == Lit) light_surfels(work);
    }
}

/// The rays of a probe with random radiance, and points that look it up.
struct LookUps {
    const Surfels& surfels = surfel_work(0).cache.surfels();
    RayEnds ends{surfels, 20.f};
    glm::vec3 probe{0.f, 200.f, 0.f};
    std::vector<float> radiance;
    std::vector<glm::vec3> points;
    glm::vec3 n{0.f, 1.f, 0.f};

    LookUps() {
        SurfelWork& work = surfel_work(0);
        probe = probe_position(work.cache.grid(), 0);
        for (std::size_t ray = 0; ray < 64; ++ray) ends.set(0, ray, probe, surfels);
        std::mt19937 engine(1);
        std::uniform_real_distribution<float> uniform(0.f, 20.f);
        for (int i = 0; i < 3 * 64; ++i) radiance.push_back(uniform(engine));
        for (int i = 0; i < 1024; ++i) {
            const float x = uniform(engine);
            const float y = uniform(engine);
            points.push_back(probe + glm::vec3(x, y, uniform(engine)));
        }
    }
};

void look_up(benchmark::State& state) {
    const LookUps work;
    for (auto _ : state) {
        for (const glm::vec3& x : work.points) {
            benchmark::DoNotOptimize(work.ends.from_point(0, x, work.n, work.radiance.data()));
        }
    }
    count_rate(state, "look-ups/s", work.points.size());
}

/// RayEnds::from_point() as its formula stands, a ray at a time.
RaySums ray_by_ray(const LookUps& work, const glm::vec3& x) {
    RaySums sums;
    for (std::size_t i = 0; i < 64; ++i) {
        const bool hit = work.surfels.hit(i);
        const glm::vec3& direction = work.surfels.direction[i];
        const float d = hit ? work.surfels.place[i].distance : 2e5f;
        const glm::vec3 n = hit ? work.surfels.place[i].n : -direction;
        const glm::vec3 way = work.probe + d * direction - x;
        const float d2 = glm::dot(way, way);
        const float distance = std::sqrt(d2);
        const float area = d * d / std::max(-glm::dot(n, direction), 1e-3f);
        const float ratio = area * std::max(0.f, -glm::dot(n, way)) / distance / d2;
        const float t = std::max(0.f, glm::dot(work.n, way)) / distance *
                        std::clamp(ratio, 1.f / RayEnds::most_magnified, RayEnds::most_magnified);
        const float* L = &work.radiance[i];
        sums.radiance += t * Spectrum(L[0], L[64], L[128]);
        sums.weight += t;
    }
    return sums;
}

void look_up_ray_by_ray(benchmark::State& state) {
    const LookUps work;
    for (auto _ : state) {
        for (const glm::vec3& x : work.points) benchmark::DoNotOptimize(ray_by_ray(work, x));
    }
    count_rate(state, "look-ups/s", work.points.size());
}

// Scene 0: cornell-box; 1: room-with-door at frame 350. Kind 0: placing; 1: seeing probes; 2:
// light.
BENCHMARK(place_and_light)
    ->ArgNames({"scene"})
    ->Arg(0)
    ->Arg(1)
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(part_of_surfels)
    ->ArgNames({"scene", "part"})
    ->ArgsProduct({{0, 1}, {SetUp, Hits, CulledHits, Planes, SeenByPlanes, SeenByRays, Lit}})
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(replay_surfel_rays)
    ->ArgNames({"scene", "kind", "width"})
    ->ArgsProduct({{0, 1}, {Place, See, Light}, {1, 4, 8}})
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(look_up)->Unit(benchmark::kMicrosecond);
BENCHMARK(look_up_ray_by_ray)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace plumbline::ddgi
