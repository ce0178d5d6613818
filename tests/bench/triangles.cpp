// SPDX-License-Identifier: Apache-2.0
// Time and memory against the number of triangles: hills on a square, seen by random rays.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <random>

#include "scenes/ray_tracer.h"

namespace plumbline {
namespace {

/// About `triangles` triangles over [0,1]^2 in x and z.
World hills(std::int64_t triangles) {
    const auto side = static_cast<unsigned>(std::sqrt(double(triangles) / 2.));
    WorldMesh mesh;
    mesh.object = 0;
    const auto vertex = [&](unsigned i, unsigned j) { return i * (side + 1) + j; };
    for (unsigned i = 0; i <= side; ++i) {
        for (unsigned j = 0; j <= side; ++j) {
            const glm::vec2 p = glm::vec2(i, j) / float(side);
            const float y = .05f * std::sin(40.f * p.x) * std::cos(30.f * p.y);
            mesh.positions.push_back({p.x, y, p.y});
            if (i == side || j == side) continue;
            mesh.triangles.push_back({vertex(i, j), vertex(i, j + 1), vertex(i + 1, j)});
            mesh.triangles.push_back({vertex(i + 1, j), vertex(i, j + 1), vertex(i + 1, j + 1)});
        }
    }
    mesh.triangle_materials.assign(mesh.triangles.size(), 0);
    World world;
    world.materials = {{}};
    world.objects = {{"hills", glm::mat4(1.f), {}}};
    world.meshes = {std::move(mesh)};
    return world;
}

/// Resident memory of the process, bytes [proc(5), /proc/self/statm].
double resident() {
    long total = 0, pages = 0;
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen("/proc/self/statm", "r"),
                                                               std::fclose);
    constexpr double page = 4096.;
    if (!file || std::fscanf(file.get(), "%ld %ld", &total, &pages) != 2) return 0.;
    return double(pages) * page;
}

std::vector<RayLanes> random_rays() {
    constexpr std::size_t count = 1 << 16;
    std::mt19937 random(1);
    std::uniform_real_distribution<float> uniform(0.f, 1.f);
    std::vector<RayLanes> rays(count / lane_count);
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec3 from(uniform(random), 1.f, uniform(random));
        const glm::vec3 to(uniform(random), 0.f, uniform(random));
        rays[i / lane_count].push({from, glm::normalize(to - from)});
    }
    return rays;
}

void hills_rays(benchmark::State& state) {
    const World world = hills(state.range(0));
    const std::vector<RayLanes> rays = random_rays();
    HitLanes hits;
    const double before = resident();
    const RayTracer tracer(world);
    state.counters["BVH bytes/triangle"] = (resident() - before) / double(world.triangle_count());
    for (auto _ : state) {
        for (const RayLanes& some : rays) {
            tracer.intersect(some, BackFaces::Hit, Coherence::Incoherent, hits);
            benchmark::DoNotOptimize(hits.count);
        }
    }
    state.counters["rays/s"] = benchmark::Counter(
        double(state.iterations()) * double(rays.size() * lane_count), benchmark::Counter::kIsRate);
}

void hills_build(benchmark::State& state) {
    const World world = hills(state.range(0));
    for (auto _ : state) benchmark::DoNotOptimize(RayTracer(world).world().triangle_count());
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

BENCHMARK(hills_rays)->Arg(1'000)->Arg(100'000)->Arg(10'000'000)->Unit(benchmark::kMillisecond);
BENCHMARK(hills_build)
    ->Arg(1'000)
    ->Arg(100'000)
    ->Arg(10'000'000)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace plumbline
