// SPDX-License-Identifier: Apache-2.0
// One light of many at each surface point, in place of all of them.
#include "pathtracer/light_choice.h"

#include <catch2/catch.hpp>
#include <numbers>
#include <random>

#include "pathtracer/passes.h"
#include "tests/pathtracer/scenes.h"
#include "tests/pathtracer/statistics.h"

namespace plumbline::pathtracer {
namespace {

using std::numbers::pi;

struct Random {
    std::mt19937_64 engine{29};
    std::uniform_real_distribution<float> uniform{0.f, 1.f};
    float number() { return uniform(engine); }
    glm::vec3 in_cube() { return 2.f * glm::vec3(number(), number(), number()) - 1.f; }
    glm::vec3 direction() {
        for (;;) {
            const glm::vec3 v = in_cube();
            const float length = glm::length(v);
            if (length > .1f && length < 1.f) return v / length;
        }
    }
};

/// Lights of every kind and falloff, in turns, inside the cube of this half side.
std::vector<PointLight> mixed_lights(int count, float half, Random& random) {
    std::vector<PointLight> lights;
    for (int i = 0; i < count; ++i) {
        PointLight light = test::inverse_square(half * random.in_cube(), {.2f, .3f, .1f});
        light.intensity *= random.number() / float(count);
        if (i % 2 == 1) {
            light.falloff = Falloff::None;
            light.white_radiance = Spectrum(.2f * random.number() / float(count));
        }
        if (i % 3 == 1) light.radius = .05f * half;
        if (i % 3 == 2) {
            const float inner = random.number();
            light.cone = SpotCone{random.direction(), inner, inner + .5f * random.number() + .01f};
        }
        lights.push_back(light);
    }
    return lights;
}

LightTree tree_of(const std::vector<PointLight>& lights) {
    std::vector<LightBounds> bounds;
    for (const PointLight& light : lights) bounds.push_back(light_bounds(light));
    return LightTree(bounds);
}

constexpr Effects point_like =
    Effects{} | Effect::PointLights | Effect::SphereLights | Effect::SpotLights;

std::vector<PixelEstimate> pixels_of(const RayTracer& tracer, Effects effects, std::uint64_t seed) {
    Progress::silence();
    constexpr int spp = 64 * Sampler::batch_size;
    Passes passes(tracer, effects, {}, seed);
    Progress progress("test", passes.steps(spp));
    passes.add({spp, Sampler::batch_size}, progress);
    return passes.pixels();
}

}  // namespace

TEST_CASE("two lights without size are chosen in proportion to the irradiance they bring",
          "[pathtracer][analytic]") {
    // E = I cos / d^2, or pi L cos without falloff.
    Random random;
    for (int i = 0; i < 200; ++i) {
        PointLight falling = test::inverse_square(random.in_cube(), Spectrum(.4f));
        PointLight even{.name = "even", .position = random.in_cube(), .falloff = Falloff::None};
        even.white_radiance = Spectrum(.3f);
        const LightTree tree = tree_of({falling, even});
        const glm::vec3 x = 3.f * random.in_cube();
        const glm::vec3 n = random.direction();
        const auto cosine = [&](const glm::vec3& to) {
            return std::max(0., double(glm::dot(n, glm::normalize(to - x))));
        };
        const glm::dvec3 way(falling.position - x);
        const double E_falling = .4 * cosine(falling.position) / glm::dot(way, way);
        const double E_even = pi * .3 * cosine(even.position);
        if (E_falling + E_even == 0.) {
            CHECK_FALSE(tree.choose(x, n, .5f));
            continue;
        }
        CHECK(double(tree.probability(0, x, n)) ==
              Approx(E_falling / (E_falling + E_even)).epsilon(1e-4).margin(1e-6));
    }
}

TEST_CASE("every light that reaches a point can be chosen there", "[pathtracer][sampler]") {
    Random random;
    const std::vector<PointLight> lights = mixed_lights(300, 1.f, random);
    const LightTree tree = tree_of(lights);
    std::size_t reaching = 0;
    for (int point = 0; point < 300; ++point) {
        const glm::vec3 x = 1.5f * random.in_cube();
        const glm::vec3 n = random.direction();
        for (std::size_t i = 0; i < lights.size(); ++i) {
            if (lights[i].radius > 0.f) continue;
            if (sample_point_light(lights[i], x, n).E == Spectrum(0.f)) continue;
            ++reaching;
            CHECK(tree.probability(std::uint32_t(i), x, n) > 0.f);
        }
    }
    CHECK(reaching > 10'000);
}

TEST_CASE("a light on the surface itself spoils no choice", "[pathtracer][sampler]") {
    const glm::vec3 x(.5f, -.25f, 2.f);
    PointLight strong = test::inverse_square(x, Spectrum(1e20f));
    const LightTree tree = tree_of({strong, strong, test::inverse_square({3.f, 0.f, 3.f}, {})});
    CHECK_FALSE(tree_of({}).choose(x, {0.f, 0.f, 1.f}, .5f));
    for (const float u : {0.f, .3f, .6f, .999f}) {
        const auto choice = tree.choose(x, {0.f, 0.f, 1.f}, u);
        REQUIRE(choice);
        CHECK(choice->light < 2);
        CHECK(choice->probability == Approx(.5));
    }
}

TEST_CASE("of a thousand lights each is chosen as often as the tree says",
          "[pathtracer][statistics]") {
    Random random;
    constexpr int count = 1000, draws = 1'000'000;
    const LightTree tree = tree_of(mixed_lights(count, 1.f, random));
    const glm::vec3 x(.3f, -.2f, .1f), n(0.f, 1.f, 0.f);
    std::vector<double> seen(count + 1, 0.);
    for (int i = 0; i < draws; ++i) {
        const auto choice = tree.choose(x, n, random.number());
        seen[choice ? choice->light : count] += 1.;
    }
    // The last cell: none, and lights too unlikely for Pearson's statistic.
    constexpr double least = 20.;
    std::vector<double> cells{seen[count]}, expected{double(draws)};
    for (std::uint32_t light = 0; light < count; ++light) {
        const double often = draws * double(tree.probability(light, x, n));
        if (often < least) {
            cells[0] += seen[light];
            continue;
        }
        cells.push_back(seen[light]);
        expected.push_back(often);
        expected[0] -= often;
    }
    CHECK(cells.size() > count / 4);
    CHECK(expected[0] > least);
    CHECK(std::abs(::plumbline::test::chi_square_z(cells, expected)) <
          ::plumbline::test::sidak_limit(1));
}

TEST_CASE("a thousand lights on a line make a shallow tree", "[pathtracer]") {
    std::vector<PointLight> lights;
    for (int i = 0; i < 1000; ++i) {
        lights.push_back(test::inverse_square({float(i), 2.f, 3.f}, Spectrum(1.f)));
    }
    CHECK(tree_of(lights).depth() < 20);
}

TEST_CASE("one of a thousand lights at a time gives the irradiance of all",
          "[pathtracer][analytic]") {
    // Over an open floor: sum of I cos / d^2 and pi L cos; a ball above the horizon lights like its
    // centre.
    Random random;
    constexpr double rho = .6;
    Scene scene;
    scene.name = "floor";
    const int grey = test::add_material(scene, Spectrum(float(rho)));
    test::add_object(scene, Quad{{-9.f, 0.f, -9.f}, {0.f, 0.f, 18.f}, {18.f, 0.f, 0.f}, grey});
    scene.lights = mixed_lights(1000, 1.f, random);
    double E = 0.;
    for (PointLight& light : scene.lights) {
        light.position.y = 1.2f + .9f * light.position.y;
        if (light.cone) light.cone->direction = glm::normalize(light.cone->direction);
        const glm::dvec3 way(light.position);
        const double d2 = glm::dot(way, way);
        double its = light.falloff == Falloff::None ? pi * double(light.white_radiance.x)
                                                    : double(light.intensity.x) / d2;
        if (light.cone) its *= double(spot_attenuation(*light.cone, light.position));
        E += its * way.y / std::sqrt(d2);
    }
    const World world = world_at(scene, 0);
    const RayTracer tracer(world);
    const LightChoice choice(world);
    PathOptions options = test::bounces(0);
    options.lights = &choice;
    const Ray ray{{-3.f, .5f, 0.f}, glm::normalize(glm::vec3(3.f, -.5f, 0.f))};
    const PixelEstimate estimate = test::estimate_along(tracer, ray, 4000, options);
    CHECK(std::abs(test::radiance_z(estimate, 0, rho / pi * E)) < 4.);
    CHECK(std::sqrt(estimate.radiance_variance().x) < .01 * rho / pi * E);
}

TEST_CASE("choosing among lights and sampling all of them agree in every pixel",
          "[pathtracer][statistics]") {
    Random random;
    Scene scene = test::mixed_room(12, 8);
    for (Material& material : scene.materials) material.emission = Spectrum(0.f);
    scene.lights = mixed_lights(40, .8f, random);
    const World world = world_at(scene, 0);
    const RayTracer tracer(world);
    const auto all = pixels_of(tracer, point_like, 1);
    const auto chosen = pixels_of(tracer, point_like | Effect::LightChoice, 2);
    double worst = 0., all_variance = 0., chosen_variance = 0.;
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            const double difference =
                (all[i].sums.radiance()[c] - chosen[i].sums.radiance()[c]) / all[i].sums.samples;
            const double variance =
                all[i].radiance_variance()[c] + chosen[i].radiance_variance()[c];
            worst = std::max(worst, std::abs(difference) / std::sqrt(variance));
            all_variance += all[i].radiance_variance()[c];
            chosen_variance += chosen[i].radiance_variance()[c];
        }
    }
    CHECK(worst < ::plumbline::test::sidak_limit(3 * int(all.size())));
    // It does choose, and well: 40 lights cost far less than 40 times the variance.
    CHECK(chosen_variance > all_variance);
    CHECK(chosen_variance < 15. * all_variance);
}

TEST_CASE("a strong light behind a wall does not hide the weak ones in front of it",
          "[pathtracer][statistics]") {
    Scene scene = test::mixed_room(8, 6);
    for (Material& material : scene.materials) material.emission = Spectrum(0.f);
    const int black = test::add_material(scene, Spectrum(0.f));
    const glm::vec3 sealed(.6f, .6f, -.6f);
    test::add_object(scene,
                     Box{sealed - .1f, sealed + .1f, {black, black, black, black, black, black}});
    Random random;
    scene.lights = mixed_lights(12, .4f, random);
    for (const float strength : {1e4f, 1e20f}) {
        scene.lights.push_back(test::inverse_square(sealed, Spectrum(strength)));
        const World world = world_at(scene, 0);
        const RayTracer tracer(world);
        const auto all = pixels_of(tracer, point_like, 1);
        const auto chosen = pixels_of(tracer, point_like | Effect::LightChoice, 2);
        double difference = 0., variance = 0.;
        for (std::size_t i = 0; i < all.size(); ++i) {
            const glm::dvec3 its = chosen[i].sums.radiance() / double(chosen[i].sums.samples) -
                                   all[i].sums.radiance() / double(all[i].sums.samples);
            difference += its.x + its.y + its.z;
            for (int c = 0; c < 3; ++c) {
                variance += all[i].radiance_variance()[c] + chosen[i].radiance_variance()[c];
            }
        }
        INFO("strength " << strength << ": " << difference << " in all, variance " << variance);
        CHECK(variance > 0.);
        // Channels share their light, so that their variances add up to a third at worst.
        CHECK(std::abs(difference) < 4. * std::sqrt(3. * variance));
    }
}

TEST_CASE("few lights are all sampled and many are chosen among", "[pathtracer]") {
    Random random;
    Scene scene = test::mixed_room(8, 6);
    for (const int count : {1, 8, 9, 1000}) {
        scene.lights = mixed_lights(count, .8f, random);
        CHECK(has(effects_of(scene), Effect::LightChoice) == (count > 8));
        const auto reasons = effect_reasons(scene);
        const auto reason = std::ranges::find(reasons, "choosing among lights",
                                              [](const EffectReason& r) { return r.effect; });
        REQUIRE(reason != reasons.end());
        CHECK(reason->simulated == (count > 8));
        CHECK(reason->why.starts_with(std::to_string(count) + " "));
    }
    // Dark lights count for nothing.
    scene.lights = mixed_lights(8, .8f, random);
    scene.lights.resize(20);
    CHECK_FALSE(has(effects_of(scene), Effect::LightChoice));
}

}  // namespace plumbline::pathtracer
