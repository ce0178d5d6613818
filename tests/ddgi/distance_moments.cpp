// SPDX-License-Identifier: Apache-2.0
#include "ddgi/distance_moments.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/ddgi/small_scenes.h"

using namespace plumbline;
using namespace plumbline::ddgi;

namespace {

/// A scene's probes at a frame, and how far they see.
struct Seen {
    Scene scene;
    World world;
    RayTracer tracer;
    SurfelCache cache;
    ProbeDistances distances;

    Seen(Scene from, int frame, int rays)
        : scene(std::move(from)),
          world(world_at(scene, frame)),
          tracer(world),
          cache(probe_grid(scene), sphere_pattern(rays, true), Reach::FirstSurface) {
        cache.rebuild(tracer);
        distances.trace(tracer, cache, nullptr);
    }
};

/// A texel of an 8 x 8 map and its neighbours, no more.
constexpr float near_in_map = 1.f;

float blended(const TexelBlend& blend) {
    float sum = 0.f;
    for (std::size_t k = 0; k < 4; ++k)
        sum += blend.weight[k] * std::sin(12.9898f * float(blend.texel[k]));
    return sum;
}

}  // namespace

TEST_CASE("octahedral texels stand for their centres and blend with those around them",
          "[ddgi][octahedral]") {
    const int side = GENERATE(8, 16);
    const OctahedralTexels texels(side);
    REQUIRE(texels.size() == static_cast<std::size_t>(side * side));
    for (std::size_t t = 0; t < texels.size(); ++t) {
        const TexelBlend blend = texels.at(texels.direction(t));
        float own = 0.f;
        for (std::size_t k = 0; k < 4; ++k)
            if (blend.texel[k] == t) own += blend.weight[k];
        CHECK(own == Approx(1.f).margin(1e-4));
    }
    for (const glm::vec3& n : sphere_pattern(4096, false).directions) {
        const TexelBlend blend = texels.at(n);
        float sum = 0.f;
        for (std::size_t k = 0; k < 4; ++k) {
            REQUIRE(blend.weight[k] >= 0.f);
            sum += blend.weight[k];
            // Across the border of the square too, where a wrong texel would be far away.
            REQUIRE(glm::distance(texels.direction(blend.texel[k]), n) <
                    near_in_map * 8.f / float(side));
        }
        REQUIRE(sum == Approx(1.f));
    }
}

TEST_CASE("octahedral maps are continuous across the border of the square", "[ddgi][octahedral]") {
    const OctahedralTexels texels(8);
    for (int i = 1; i < 100; ++i) {
        const float along = float(i) / 50.f - 1.f;
        const float inner = 1.f - 1e-5f;
        // The border folds onto itself: (1, v) is (1, -v), and (u, 1) is (-u, 1).
        CHECK(blended(texels.at(octahedral_direction({inner, along}))) ==
              Approx(blended(texels.at(octahedral_direction({inner, -along})))).margin(1e-3));
        CHECK(blended(texels.at(octahedral_direction({along, -inner}))) ==
              Approx(blended(texels.at(octahedral_direction({-along, -inner})))).margin(1e-3));
    }
}

TEST_CASE("lobes of texels are powers of the cosine", "[ddgi][octahedral]") {
    const OctahedralTexels texels(8);
    const int power = GENERATE(1, 2, 3, 50);
    const glm::vec3 w = glm::normalize(glm::vec3(.3f, -.5f, .8f));
    for (std::size_t first = 0; first < texels.size(); first += OctahedralTexels::lanes) {
        const auto lobes = texels.lobes(first, w, power);
        for (std::size_t i = 0; i < lobes.size(); ++i) {
            const double cosine = std::max(0., double(glm::dot(w, texels.direction(first + i))));
            CHECK(lobes[i] == Approx(std::pow(cosine, power)).epsilon(1e-4).margin(1e-30));
        }
    }
}

TEST_CASE("a probe in the middle of a sphere sees all points inside it and none outside",
          "[ddgi][moments][analytic]") {
    Scene scene = integrating_sphere(.5f, glm::vec3(0.f));  // of radius 2
    scene.probes = ProbeGrid{glm::vec3(0.f), 1.f, {1, 1, 1}};
    const Seen seen(scene, 0, 64);
    DistanceMoments moments(probe_grid(seen.scene), 50);
    moments.take(seen.distances, seen.cache.surfels());
    for (const glm::vec3& n : sphere_pattern(64, false).directions) {
        CHECK(moments.visibility(0, 1.98f * n) == 1.f);
        CHECK(moments.visibility(0, 2.2f * n) < .02f);
    }
    CHECK(moments.visibility(0, glm::vec3(0.f)) == 1.f);
}

TEST_CASE("visibility by moments bounds the share of a view that is farther away",
          "[ddgi][moments][analytic]") {
    // Chebyshev's one-sided inequality, at the centres of texels, against the distances themselves.
    // Of 16 rays the nearest is so far off that a cosine to the power of 1000 is 0 as a float.
    const auto [rays, sharpness] = GENERATE(table<std::size_t, int>(
        {{512, 4}, {512, 50}, {512, 1000}, {16, 50}, {16, 200}, {16, 1000}}));
    const Seen seen(room_with_moving_block(), 3, int(rays));
    const ProbeGrid grid = probe_grid(seen.scene);
    DistanceMoments moments(grid, sharpness);
    const Surfels& surfels = seen.cache.surfels();
    moments.take(seen.distances, surfels);
    const OctahedralTexels texels(16);
    int hidden = 0;
    for (const std::uint32_t probe : {0u, 86u, 93u, 129u, 215u}) {
        for (std::size_t t = 0; t < texels.size(); ++t) {
            const glm::vec3 n = texels.direction(t);
            const float r = grid.spacing * float(t % 7 + 1) / 3.f;
            double weight = 0.;
            double farther = 0.;
            for (std::size_t i = probe * rays; i < (probe + 1) * rays; ++i) {
                const double w =
                    std::pow(std::max(0., double(glm::dot(n, surfels.direction[i]))), sharpness);
                weight += w;
                if (seen.distances.distance(i) >= r) farther += w;
            }
            const float visibility = moments.visibility(probe, probe_position(grid, probe) + r * n);
            REQUIRE(visibility >= farther / weight - 1e-3);
            hidden += visibility < .1f ? 1 : 0;
        }
    }
    CHECK(hidden > 10);
}

TEST_CASE("probes in something meet backs, those in the open none", "[ddgi][moments]") {
    Scene scene = room_with_moving_block();
    // The outermost probes stand outside of the room.
    scene.probes = ProbeGrid{glm::vec3(-1.2f), .24f, {11, 11, 11}};
    const Seen seen(scene, 0, 64);
    const ProbeGrid grid = probe_grid(seen.scene);
    int in_block = 0;
    for (std::uint32_t probe = 0; probe < probe_count(grid); ++probe) {
        const float share = seen.distances.back_share(probe);
        const bool outside = max_component(glm::abs(probe_position(grid, probe))) > 1.f;
        // Its walls face inwards; what rays do not meet them leave the scene.
        if (outside) CHECK(share > 0.f);
        if (outside || share == 0.f) continue;
        CHECK(share == 1.f);
        ++in_block;
    }
    CHECK(in_block > 0);
}

TEST_CASE("distances traced where something moved are those traced afresh", "[ddgi][moments]") {
    const Scene scene = room_with_moving_block();
    Seen before(scene, 2, 64);
    for (int frame = 3; frame < 8; ++frame) {
        Seen after(scene, frame, 64);
        const Motion motion = motion_between(world_at(scene, frame - 1), after.world);
        before.distances.trace(after.tracer, before.cache, &motion);
        std::size_t kept = 0;
        for (std::size_t i = 0; i < after.cache.surfels().size(); ++i) {
            REQUIRE(before.distances.distance(i) == after.distances.distance(i));
            REQUIRE(before.distances.back(i) == after.distances.back(i));
        }
        for (std::size_t probe = 0; probe < probe_count(probe_grid(scene)); ++probe)
            kept += before.distances.changed(probe) ? 0 : 1;
        CHECK((frame <= 6 ? kept < probe_count(probe_grid(scene)) : kept > 0));
    }
}

TEST_CASE("turned rays keep their angles, and fill all directions over the turns",
          "[ddgi][patterns]") {
    const RayPattern pattern = sphere_pattern(64, false);
    glm::dvec3 sum(0.);
    glm::dmat3 second(0.);
    constexpr int turns = 512;
    for (int turn = 0; turn < turns; ++turn) {
        const RayPattern now = turned(pattern, turn);
        CHECK(glm::dot(now.directions[3], now.directions[40]) ==
              Approx(glm::dot(pattern.directions[3], pattern.directions[40])).margin(1e-5));
        const glm::dvec3 w(now.directions[7]);
        sum += w / double(turns);
        second += glm::outerProduct(w, w) / double(turns);
    }
    // Of directions that are even over the sphere the mean is 0 and <w w^T> a third.
    CHECK(glm::length(sum) < .02);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            CHECK(second[i][j] == Approx(i == j ? 1. / 3. : 0.).margin(.02));
}
