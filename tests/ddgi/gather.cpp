// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>
#include <glm/gtc/constants.hpp>
#include <numeric>
#include <random>

#include "ddgi/feedback_maps.h"
#include "ddgi/irradiance_map.h"
#include "ddgi/patterns.h"
#include "ddgi/probe_weigher.h"
#include "ddgi/ray_gather.h"
#include "ddgi/seen_probes.h"
#include "tests/ddgi/small_scenes.h"

using namespace plumbline;
using namespace plumbline::ddgi;

namespace {

glm::vec3 random_direction(std::mt19937& engine) {
    std::normal_distribution<float> normal;
    return glm::normalize(glm::vec3(normal(engine), normal(engine), normal(engine)));
}

RayEnds ends_of(const Surfels& surfels, const glm::vec3& position) {
    RayEnds ends(surfels, 1.f);
    for (std::size_t ray = 0; ray < surfels.size(); ++ray) ends.set(0, ray, position, surfels);
    return ends;
}

/// One probe at `position` inside the sphere of radius 2, its rays traced by hand.
Surfels surfels_in_sphere(const RayPattern& pattern, const glm::vec3& position) {
    constexpr float radius = 2.f;
    Surfels surfels;
    surfels.resize(1, pattern.size());
    for (std::size_t i = 0; i < surfels.size(); ++i) {
        const glm::vec3 w = pattern.directions[i];
        const float b = glm::dot(position, w);
        const float t = -b + std::sqrt(b * b - glm::dot(position, position) + radius * radius);
        surfels.direction[i] = w;
        surfels.place[i].distance = t;
        surfels.place[i].n = -(position + t * w) / radius;
    }
    return surfels;
}

}  // namespace

TEST_CASE("rays summed in lanes are the sum of their weights times radiance", "[ddgi]") {
    std::mt19937 engine(7);
    std::uniform_real_distribution<float> uniform(0.f, 1.f);
    const RayPattern pattern = sphere_pattern(64, true);
    const Surfels surfels = surfels_in_sphere(pattern, {.3f, -.2f, .5f});
    const RayEnds ends = ends_of(surfels, {.3f, -.2f, .5f});
    std::vector<float> radiance(3 * surfels.size());
    for (float& L : radiance) L = uniform(engine);
    const glm::vec3 n = random_direction(engine);
    const RaySums sums = ends.along_rays(0, n, radiance.data());
    glm::dvec3 expected(0.);
    double weight = 0.;
    for (std::size_t i = 0; i < surfels.size(); ++i) {
        const double t = std::max(0., glm::dot(glm::dvec3(n), glm::dvec3(surfels.direction[i])));
        weight += t;
        for (int c = 0; c < 3; ++c) {
            expected[c] += t * double(radiance[std::size_t(c) * surfels.size() + i]);
        }
    }
    CHECK(sums.weight == Approx(weight));
    for (int c = 0; c < 3; ++c) CHECK(sums.radiance[c] == Approx(expected[c]));
}

TEST_CASE("where the point is the probe both ways to gather are one", "[ddgi]") {
    std::mt19937 engine(11);
    const glm::vec3 x(.4f, .1f, -.3f);
    const Surfels surfels = surfels_in_sphere(sphere_pattern(128, true), x);
    const RayEnds ends = ends_of(surfels, x);
    const std::vector<float> radiance(3 * surfels.size(), 1.f);
    for (int i = 0; i < 20; ++i) {
        const glm::vec3 n = random_direction(engine);
        CHECK(ends.from_point(0, x, n, radiance.data()).weight ==
              Approx(ends.along_rays(0, n, radiance.data()).weight).epsilon(1e-4));
    }
}

TEST_CASE("seen from another point the rays' patches still cover half the cosine-weighted sphere",
          "[ddgi][analytic]") {
    // Inside a sphere all is seen from everywhere: sum_i t_i 4 pi / N estimates the integral of the
    // cosine over the hemisphere, pi, from wherever the probe stands.
    std::mt19937 engine(13);
    const glm::vec3 probe(.2f, -.3f, .1f);
    const Surfels surfels = surfels_in_sphere(sphere_pattern(4096, true), probe);
    const RayEnds ends = ends_of(surfels, probe);
    const std::vector<float> radiance(3 * surfels.size(), 1.f);
    const double solid_angle = 4. * glm::pi<double>() / double(surfels.size());
    for (int i = 0; i < 20; ++i) {
        const glm::vec3 x = probe + .4f * random_direction(engine);
        const RaySums sums = ends.from_point(0, x, random_direction(engine), radiance.data());
        CHECK(double(sums.weight) * solid_angle == Approx(glm::pi<double>()).epsilon(.01));
    }
}

TEST_CASE("a ray that ends at the point itself brings nothing and no NaN", "[ddgi]") {
    const Surfels surfels = surfels_in_sphere(sphere_pattern(8, false), glm::vec3(0.f));
    const RayEnds ends = ends_of(surfels, glm::vec3(0.f));
    const std::vector<float> radiance(3 * surfels.size(), 1.f);
    const glm::vec3 x = surfels.place[0].distance * surfels.direction[0];
    CHECK(std::isfinite(ends.from_point(0, x, surfels.place[0].n, radiance.data()).weight));
}

TEST_CASE("a map interpolates between nodes with weights that sum to one", "[ddgi]") {
    std::mt19937 engine(17);
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 n = random_direction(engine);
        const MapPoint at = map_point(n);
        glm::vec3 mean(0.f);
        float sum = 0.f;
        for (std::size_t k = 0; k < 4; ++k) {
            REQUIRE(at.weight[k] >= 0.f);
            REQUIRE(at.node[k] < map_nodes);
            sum += at.weight[k];
            mean += at.weight[k] * map_directions()[at.node[k]];
        }
        REQUIRE(sum == Approx(1.f));
        REQUIRE(glm::dot(glm::normalize(mean), n) > std::cos(glm::radians(9.f)));
    }
}

TEST_CASE("the six axes are nodes of the map", "[ddgi]") {
    for (int axis = 0; axis < 3; ++axis) {
        for (const float sign : {-1.f, 1.f}) {
            glm::vec3 n(0.f);
            n[axis] = sign;
            const MapPoint at = map_point(n);
            const auto largest =
                std::size_t(std::ranges::max_element(at.weight) - at.weight.begin());
            CHECK(at.weight[largest] == Approx(1.f));
            CHECK(glm::distance(map_directions()[at.node[largest]], n) < 1e-6f);
        }
    }
}

TEST_CASE("surfels gather what the nodes around their normals interpolate to", "[ddgi]") {
    std::mt19937 engine(23);
    std::uniform_real_distribution<float> uniform(0.f, 1.f);
    const ProbeGrid grid{glm::vec3(-.5f), 1.f, {2, 2, 1}};  // thinner than a cell along z
    const Surfels surfels = surfels_in_sphere(sphere_pattern(64, true), {.1f, 0.f, 0.f});
    std::vector<float> radiance(4 * 3 * 64);
    for (float& L : radiance) L = uniform(engine);
    Surfels all;
    all.resize(4, 64);
    for (std::size_t i = 0; i < all.size(); ++i) all.direction[i] = surfels.direction[i % 64];
    RayEnds ends(all, 1.f);
    for (std::size_t i = 0; i < all.size(); ++i) ends.set(i / 64, i % 64, glm::vec3(0.f), all);

    FeedbackMaps maps(grid);
    std::vector<MapGather> gathers;
    std::vector<Spectrum> expected;
    for (int i = 0; i < 40; ++i) {
        glm::vec3 n = random_direction(engine);
        if (i < 6) n = (i < 3 ? 1.f : -1.f) * glm::vec3(i % 3 == 0, i % 3 == 1, i % 3 == 2);
        const ProbeNeighbours around = probe_neighbours(grid, uniform(engine) * n);
        gathers.push_back(maps.gather(around, n));
        const MapPoint at = map_point(n);
        Spectrum E(0.f);
        for (std::size_t k = 0; k < 8; ++k) {
            for (std::size_t node = 0; node < 4; ++node) {
                const RaySums sums =
                    ends.along_rays(around.probe[k], map_directions()[at.node[node]],
                                    &radiance[around.probe[k] * 3 * 64]);
                E += around.weight[k] * at.weight[node] * irradiance(sums);
            }
        }
        expected.push_back(E);
    }
    std::vector<Spectrum> gathered(gathers.size());
    maps.make(ends, radiance, 64);
    maps.gather(gathers, gathered);
    for (std::size_t i = 0; i < expected.size(); ++i) {
        for (int c = 0; c < 3; ++c) CHECK(gathered[i][c] == Approx(expected[i][c]).epsilon(1e-5));
    }
}

TEST_CASE("shifted patterns stay even and differ from probe to probe", "[ddgi]") {
    const RayPattern pattern = sphere_pattern(64, true);
    const auto here = probe_directions(pattern, {3, 4, 5});
    const auto there = probe_directions(pattern, {4, 4, 5});
    CHECK(here != there);
    CHECK(here == probe_directions(pattern, {3, 4, 5}));
    std::vector<float> heights;
    for (const glm::vec3& w : here) {
        heights.push_back(w.y);
        CHECK(glm::length(w) == Approx(1.f));
    }
    std::ranges::sort(heights, std::greater());
    for (std::size_t i = 0; i < heights.size(); ++i) {
        // One ray in each of the 64 slices of equal area.
        CHECK(heights[i] <= 1.f - 2.f * float(i) / 64.f + 1e-6f);
        CHECK(heights[i] >= 1.f - 2.f * float(i + 1) / 64.f - 1e-6f);
    }
    CHECK(probe_directions(sphere_pattern(64, false), {3, 4, 5}) ==
          sphere_pattern(64, false).directions);
}

TEST_CASE("the rays of a block point much the same way at every probe", "[ddgi]") {
    const auto rays = GENERATE(64, 96, 256, 1000);
    const RayPattern pattern = sphere_pattern(rays, true);
    for (const glm::ivec3& cell : {glm::ivec3(0), glm::ivec3(3, 4, 5), glm::ivec3(20, 1, 7)}) {
        const auto directions = probe_directions(pattern, cell);
        for (std::size_t first = 0; first < directions.size(); first += rays_in_block) {
            const auto block = std::span(directions).subspan(first, rays_in_block);
            const glm::vec3 sum = std::accumulate(block.begin(), block.end(), glm::vec3(0.f));
            // Of directions even over an octant of the sphere the mean is sqrt(3) / 2 long; of a
            // ring around the equator it has no length.
            CHECK(glm::length(sum) / float(rays_in_block) > .8f);
        }
    }
}

TEST_CASE("the weights of seen probes are the trilinear ones of these made to sum to one",
          "[ddgi]") {
    const auto counts = GENERATE(glm::ivec3(4, 3, 5), glm::ivec3(1, 3, 2), glm::ivec3(3, 1, 1));
    const ProbeGrid grid{glm::vec3(-1.5f), 1.f, counts};
    std::mt19937 engine(9);
    std::uniform_real_distribution<float> uniform(-2.f, 4.f);
    for (unsigned i = 0; i < 2048; ++i) {
        const auto seen = static_cast<std::uint8_t>(i);
        const glm::vec3 x(uniform(engine), uniform(engine), uniform(engine));
        const ProbeNeighbours expected = tempered(
            probe_neighbours(grid, x),
            [&](std::size_t k, std::uint32_t) { return (seen >> k & 1) != 0 ? 1.f : 0.f; });
        const ProbeNeighbours around = seen_neighbours(grid, x, seen);
        REQUIRE(around.probe == expected.probe);
        REQUIRE(around.weight == expected.weight);
    }
}

TEST_CASE("a point sees the probes in front of it that nothing hides", "[ddgi]") {
    const World world = world_at(room_with_moving_block(), 0);
    const RayTracer tracer(world);
    const ProbeGrid grid{glm::vec3(-1.5f), 1.f, {4, 4, 4}};
    // On the floor y = -1, facing up: the four probes of the upper layer, at y = -.5.
    const glm::vec3 x(-.9f, -.999f, .9f);
    const glm::vec3 up(0.f, 1.f, 0.f);
    const ProbeNeighbours around = probe_neighbours(grid, x);
    const std::uint8_t seen = seen_probes(tracer, grid, x, up);
    for (std::size_t k = 0; k < 8; ++k) {
        const glm::vec3 probe = probe_position(grid, around.probe[k]);
        const bool inside = max_component(glm::abs(probe)) < 1.f;
        CHECK(((seen >> k & 1) != 0) == (inside && !tracer.occluded(x, probe)));
    }
    CHECK(seen != 0);
    const ProbeWeigher weigher(grid, {.weights = ProbeWeights::Visibility});
    const ProbeNeighbours weighted = weigher.weighted(x, up, seen);
    float sum = 0.f;
    for (std::size_t k = 0; k < 8; ++k) {
        sum += weighted.weight[k];
        if ((seen >> k & 1) == 0) CHECK(weighted.weight[k] == 0.f);
    }
    CHECK(sum == Approx(1.f));
    CHECK(weigher.weighted(x, up, 0).weight == around.weight);
}
