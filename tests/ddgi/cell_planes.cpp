// SPDX-License-Identifier: Apache-2.0
// Which ways to probes the planes of surfaces leave open, held against rays along all of them.
#include "ddgi/cell_planes.h"

#include <bit>
#include <catch2/catch.hpp>
#include <random>
#include <utility>

#include "ddgi/grid_cell.h"
#include "ddgi/seen_probes.h"
#include "ddgi/surfel_cache.h"
#include "scenes/scene_files.h"

using namespace plumbline;
using namespace plumbline::ddgi;

namespace {

std::uint8_t open_ways(const CellPlanes& planes, const ProbeGrid& grid, const glm::vec3& x) {
    return planes.open_ways(cell_around(grid, place_in(grid, x)), x);
}

/// A world of triangles with corners in [-1,1]^3, all in the planes of `planes` random ones.
World random_triangles(std::mt19937& engine, int planes, int a_plane) {
    std::uniform_real_distribution<float> uniform(-1.f, 1.f);
    const auto point = [&] { return glm::vec3(uniform(engine), uniform(engine), uniform(engine)); };
    World world;
    world.objects.resize(1);
    world.materials.resize(1);
    world.meshes.push_back({});
    WorldMesh& mesh = world.meshes.back();
    mesh.object = 0;
    for (int plane = 0; plane < planes; ++plane) {
        const glm::vec3 origin = point(), u = point(), v = point();
        for (int i = 0; i < a_plane; ++i) {
            const auto first = unsigned(mesh.positions.size());
            for (int corner = 0; corner < 3; ++corner) {
                mesh.positions.push_back(origin + uniform(engine) * u + uniform(engine) * v);
            }
            mesh.triangles.emplace_back(first, first + 1, first + 2);
            mesh.triangle_materials.push_back(0);
        }
    }
    return world;
}

}  // namespace

TEST_CASE("ways between random triangles that planes leave open are not blocked", "[ddgi]") {
    std::mt19937 engine(4);
    std::uniform_real_distribution<float> uniform(-1.f, 1.f);
    const ProbeGrid grid{glm::vec3(-1.f), .25f, {9, 9, 9}};
    std::size_t open_count = 0, blocked = 0;
    for (int planes = 1; planes < 30; ++planes) {
        const World world = random_triangles(engine, planes, 3);
        const RayTracer tracer(world);
        CellPlanes cells(grid);
        cells.take(world);
        for (int i = 0; i < 500; ++i) {
            const glm::vec3 x(uniform(engine), uniform(engine), uniform(engine));
            const ProbeNeighbours around = probe_neighbours(grid, x);
            const std::uint8_t open = open_ways(cells, grid, x);
            for (std::size_t k = 0; k < 8; ++k) {
                const glm::vec3 probe = probe_position(grid, around.probe[k]);
                const glm::vec3 behind = in_surface * grid.spacing * glm::normalize(probe - x);
                const bool hidden = tracer.occluded(x, probe + behind);
                if (hidden) ++blocked;
                if ((open >> k & 1) == 0) continue;
                ++open_count;
                CHECK_FALSE(hidden);
            }
        }
    }
    // That some are of each kind, so that the test could fail.
    CHECK(open_count > 10000);
    CHECK(blocked > 1000);
}

TEST_CASE("surfels see the same probes by planes and by rays alone, and most need no ray",
          "[ddgi]") {
    const auto [name, frame] =
        GENERATE(std::pair{"cornell-box", 240}, std::pair{"room-with-door", 330});
    const Scene scene = load_scene(name);
    const World world = world_at(scene, frame);
    const RayTracer tracer(world);
    SurfelCache cache(probe_grid(scene), sphere_pattern(8, true), Reach::FirstSurface,
                      ProbeWeights::Visibility);
    cache.rebuild(tracer);
    CellPlanes planes(cache.grid());
    planes.take(world);
    const Surfels& surfels = cache.surfels();
    std::size_t seen = 0, by_planes = 0, different = 0;
    for (std::size_t i = 0; i < surfels.size(); ++i) {
        if (!surfels.hit(i)) continue;
        const glm::vec3& x = surfels.place[i].position;
        const std::uint8_t by_rays = seen_probes(tracer, cache.grid(), x, surfels.place[i].n);
        if (by_rays != surfels.seen[i]) ++different;
        const std::uint8_t open = open_ways(planes, cache.grid(), x);
        seen += std::size_t(std::popcount(by_rays));
        by_planes += std::size_t(std::popcount(std::uint8_t(by_rays & open)));
    }
    CHECK(different == 0);
    CHECK(double(by_planes) > .8 * double(seen));
}

TEST_CASE("planes tell nothing where a ball is or a triangle has no area", "[ddgi]") {
    const ProbeGrid grid{glm::vec3(-1.f), .5f, {5, 5, 5}};
    const glm::vec3 near(.1f), far(-.9f);
    CellPlanes planes(grid);
    World world;
    planes.take(world);
    CHECK(open_ways(planes, grid, near) == all_probes);
    CHECK(open_ways(planes, grid, glm::vec3(1.2f)) == 0);  // outside the grid
    SECTION("a ball") { world.spheres.push_back({0, glm::vec3(.25f), .1f, false, 0}); }
    SECTION("a triangle without area") {
        world.meshes.push_back(
            {0, {{.2f, .2f, .2f}, {.3f, .3f, .3f}, {.4f, .4f, .4f}}, {}, {}, {{0, 1, 2}}, {0}});
    }
    planes.take(world);
    CHECK(open_ways(planes, grid, near) == 0);
    CHECK(open_ways(planes, grid, far) == all_probes);
}
