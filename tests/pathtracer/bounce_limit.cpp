// SPDX-License-Identifier: Apache-2.0
// Paths that stop where what is left is proven to be too little to count.
#include "pathtracer/bounce_limit.h"

#include <catch2/catch.hpp>
#include <numbers>

#include "pathtracer/passes.h"
#include "scenes/progress.h"
#include "tests/pathtracer/pictures.h"
#include "tests/pathtracer/scenes.h"

namespace plumbline::pathtracer {
namespace {

constexpr double asked = 1e-2;

Scene dark_room(float rho) {
    Scene scene = test::mixed_room(10, 8);
    for (Material& material : scene.materials) material.albedo = Spectrum(rho);
    return scene;
}

BounceLimit limit_of(const Scene& scene, const RenderOptions& options) {
    return bounce_limit(world_at(scene, 0), effects_of(scene), options);
}

}  // namespace

TEST_CASE("in a furnace the limit is where the series of bounces says", "[pathtracer][analytic]") {
    // Each ray brings Le; more than m scatterings bring Le rho^(m+1) / (1 - rho), and the bound is
    // just that. The fewest m for which its square over 0.01 is below a hundredth of relMSE.
    constexpr double Le = .25;
    const float rho = GENERATE(.05f, .1f, .3f);
    const double target = GENERATE(1e-2, 1e-3, 1e-5);
    Scene scene;
    scene.name = "furnace";
    const int wall = test::add_material(scene, Spectrum(rho), Spectrum(float(Le)));
    for (const Quad& quad : test::room_walls({wall, wall, wall, wall, wall, wall})) {
        test::add_object(scene, quad);
    }
    const double r(rho);
    int m = 1;
    while (std::pow(Le * std::pow(r, m + 1) / (1. - r), 2.) / .01 > target / 100.) ++m;
    const BounceLimit limit = limit_of(scene, {.target_relmse = target});
    REQUIRE(limit.max_bounces);
    CHECK(*limit.max_bounces == m - 1);
}

TEST_CASE("a limit is set only where an error is asked for and a bound proves it", "[pathtracer]") {
    const RenderOptions options{.target_relmse = asked};
    CHECK(limit_of(dark_room(.1f), options).max_bounces);
    CHECK_FALSE(limit_of(dark_room(.1f), {}).max_bounces);
    CHECK(limit_of(dark_room(.1f), {.target_relmse = asked, .max_bounces = 40}).max_bounces == 40);
    CHECK_FALSE(limit_of(dark_room(.7f), options).max_bounces);
    CHECK_FALSE(limit_of(dark_room(1.f), options).max_bounces);
    SECTION("one channel that absorbs nothing is enough") {
        Scene scene = dark_room(.1f);
        scene.materials[0].albedo.y = 1.f;
        CHECK_FALSE(limit_of(scene, options).max_bounces);
    }
    SECTION("a light on a surface") {
        Scene scene = dark_room(.1f);
        scene.lights[0].position = {.4f, -1.f, .3f};
        CHECK_FALSE(limit_of(scene, options).max_bounces);
    }
    SECTION("stronger light takes more bounces") {
        Scene scene = dark_room(.1f);
        const int before = *limit_of(scene, options).max_bounces;
        scene.lights[0].intensity *= 1000.f;
        CHECK(*limit_of(scene, options).max_bounces == before + 3);
    }
}

TEST_CASE("a picture that stops at its limit lacks less than the bound in every pixel",
          "[pathtracer][statistics]") {
    // The same seed finds the same paths, so that the two pictures differ by what is left alone.
    const Scene scene = dark_room(GENERATE(.1f, .2f));
    const RenderOptions options{.spp = 64, .target_relmse = asked};
    const BounceLimit limit = limit_of(scene, options);
    REQUIRE(limit.max_bounces);
    const World world = world_at(scene, 0);
    const RayTracer tracer(world);
    const auto pixels = [&](int max_scatterings) {
        Progress::silence();
        PathOptions path;
        path.max_scatterings = max_scatterings;
        path.roulette = false;
        Passes passes(tracer, effects_of(scene), path, 0);
        Progress progress("test", passes.steps(64));
        passes.add({64, Sampler::batch_size}, progress);
        return passes.pixels();
    };
    const auto stopped = pixels(*limit.max_bounces + 1);
    const auto all = pixels(30);
    const double bound = std::sqrt(asked / 100. * .01);
    double largest = 0.;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const glm::dvec3 left = (all[i].sums.radiance() - stopped[i].sums.radiance()) / 64.;
        CHECK(left.x >= 0.);
        largest = std::max({largest, left.x, left.y, left.z});
    }
    CHECK(largest > 0.);
    CHECK(largest < bound);
}

TEST_CASE("a render stops at its limit and says so", "[pathtracer]") {
    const Scene scene = dark_room(.1f);
    const RenderResult result = render(scene, 0, {.spp = 64, .target_relmse = asked});
    const int bounces = *limit_of(scene, {.target_relmse = asked}).max_bounces;
    CHECK(
        result.image.metadata.at("plumbline:bounces").starts_with(std::to_string(bounces) + ": "));
    const RenderResult asked_for = render(scene, 0, {.spp = result.spp, .max_bounces = bounces});
    const RenderResult one_more = render(scene, 0, {.spp = result.spp, .max_bounces = bounces + 1});
    CHECK(test::same_bits(result.image.layer("bounce1")[0], asked_for.image.layer("bounce1")[0]));
    CHECK(test::same_bits(result.image.layer("indirect")[0], asked_for.image.layer("indirect")[0]));
    CHECK_FALSE(
        test::same_bits(result.image.layer("indirect")[0], one_more.image.layer("indirect")[0]));
}

}  // namespace plumbline::pathtracer
