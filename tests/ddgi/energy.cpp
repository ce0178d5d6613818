// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <glm/gtc/constants.hpp>

#include "ddgi/render.h"
#include "ddgi/volume.h"
#include "tests/ddgi/small_scenes.h"

using namespace plumbline;
using namespace plumbline::ddgi;

namespace {

double largest_difference(std::span<const float> a, std::span<const float> b) {
    double largest = 0.;
    for (std::size_t i = 0; i < a.size(); ++i) {
        largest = std::max(largest, std::abs(double(a[i]) - double(b[i])));
    }
    return largest;
}

std::vector<float> copy(std::span<const float> values) { return {values.begin(), values.end()}; }

}  // namespace

TEST_CASE("furnace: a closed room that emits shows Le / (1 - rho) at every pixel",
          "[ddgi][analytic]") {
    const auto probes = GENERATE(from_range(all_probe_options()));
    const Spectrum rho(.5f, .8f, 0.f);
    const Spectrum Le(1.f, .25f, 2.f);
    DdgiOptions options;
    options.model = "conserving";
    options.probes = probes;
    const DdgiResult result = render(closed_room(rho, Le), 0, options);
    CHECK(result.figures.converged);
    CHECK(result.figures.surfels_hit == result.figures.surfels);
    for (int c = 0; c < 3; ++c) {
        const double expected = double(Le[c]) / (1. - double(rho[c]));
        const double once = double(Le[c]) * (1. + double(rho[c]));
        const auto channel = static_cast<std::size_t>(c);
        for (std::size_t i = 0; i < result.image.pixels(); ++i) {
            REQUIRE(result.image.layer("")[channel][i] == Approx(expected).epsilon(1e-3));
            // Light scattered once is direct, even where the probes bring it.
            REQUIRE(result.image.layer("direct")[channel][i] == Approx(once).epsilon(1e-5));
        }
    }
}

TEST_CASE("furnace: m updates bring m terms of the series Le (1 + rho + rho^2 + ...)",
          "[ddgi][analytic]") {
    const auto m = GENERATE(0, 1, 2, 5, 20);
    DdgiOptions options;
    options.model = "conserving";
    options.updates = m;
    const DdgiResult result = render(closed_room(Spectrum(.6f), Spectrum(1.f)), 0, options);
    CHECK(result.figures.updates == m);
    const double probes = (1. - std::pow(.6, m)) / .4;
    for (const float value : result.image.channel("R")) {
        REQUIRE(value == Approx(1. + .6 * probes).epsilon(1e-5));
    }
}

TEST_CASE("an environment of radiance L gives a wall that sees nothing else rho L",
          "[ddgi][analytic]") {
    Scene scene = closed_room(Spectrum(.5f), Spectrum(0.f));
    scene.environment = {3.f, 2.f, 1.f};
    scene.objects.resize(1);  // the wall at x = -1, which faces +x
    scene.camera.eye = {0.f, 0.f, 0.f};
    scene.camera.target = {-1.f, 0.f, 0.f};
    scene.camera.vertical_fov = .5f;
    // Behind the wall, whose back no surfel ray meets: every ray brings the environment.
    scene.probes = ProbeGrid{{-3.f, -.9f, -.9f}, .6f, {3, 4, 4}};
    DdgiOptions options;
    options.model = "conserving";
    const DdgiResult result = render(scene, 0, options);
    CHECK(result.figures.surfels_hit == 0);
    for (int c = 0; c < 3; ++c) {
        const auto direct = result.image.layer("direct");
        for (const float value : direct[static_cast<std::size_t>(c)]) {
            REQUIRE(value == Approx(.5f * scene.environment[c]).epsilon(1e-5));
        }
    }
    CHECK(mean(result.image, "indirect") == Approx(0.).margin(1e-6));
}

TEST_CASE("integrating sphere: indirect light is uniform, rho / (1 - rho) of the mean direct",
          "[ddgi][analytic]") {
    const float rho = .8f;
    const double E = 1. / 4.;  // I / r^2, the mean irradiance wherever the light stands
    const double expected = double(rho) / glm::pi<double>() * E * double(rho) / (1. - double(rho));
    DdgiOptions options;
    options.model = "conserving";

    SECTION("light in the centre: exact") {
        const DdgiResult result = render(integrating_sphere(rho, glm::vec3(0.f)), 0, options);
        for (const float value : result.image.channel("indirect.G")) {
            REQUIRE(value == Approx(expected).epsilon(1e-3));
        }
    }
    SECTION("light off the centre: within the model's error") {
        const DdgiResult result = render(integrating_sphere(rho, {.4f, .7f, -.2f}), 0, options);
        CHECK(mean(result.image, "indirect") == Approx(expected).epsilon(.02));
    }
}

TEST_CASE("conserving updates contract: the error after m of them is at most albedo^m of the light",
          "[ddgi][analytic]") {
    const Scene scene = room_with_moving_block();
    DdgiOptions options;
    options.model = "conserving";
    options.probes = GENERATE(from_range(all_probe_options()));
    // Their kernel is negative here and there: see the spectral radius for them.
    if (options.probes.storage == Storage::Sh2 || options.probes.storage == Storage::Sh3) return;
    ProbeVolume settled(scene, options);
    settled.move_to(0);
    for (int i = 0; i < 150; ++i) settled.update();
    const std::vector<float> limit = copy(settled.values());
    const double light = largest_difference(limit, std::vector<float>(limit.size()));
    REQUIRE(light > 0.);

    constexpr double largest_albedo = .9;
    constexpr double rounding = 1e-5;
    ProbeVolume volume(scene, options);
    volume.move_to(0);
    double error = light;
    for (int m = 1; m <= 30; ++m) {
        volume.update();
        const double next_error = largest_difference(volume.values(), limit);
        CHECK(next_error <= largest_albedo * error + rounding * light);
        CHECK(next_error <= (std::pow(largest_albedo, m) + rounding) * light);
        error = next_error;
    }
}

TEST_CASE("no probe holds more radiance than its brightest source allows", "[ddgi][analytic]") {
    // max L <= max(E_direct rho / pi) / (1 - rho): the closed form of the contraction's bound.
    const Scene scene = room_with_moving_block();
    DdgiOptions options;
    options.model = "conserving";
    ProbeVolume volume(scene, options);
    volume.move_to(0);
    volume.converge();
    CHECK(volume.figures().converged);
    const float largest = *std::ranges::max_element(volume.values());
    CHECK(largest > 0.f);
    CHECK(largest <= .9f / (1.f - .9f));
}

TEST_CASE("a picture of the environment that is even gives the light of an even environment",
          "[ddgi]") {
    Scene scene = room_with_moving_block();
    scene.objects.erase(scene.objects.begin());  // a wall
    scene.environment = {3.f, 2.f, 1.f};
    const Image plain = render(scene, 0, {}).image;
    auto panorama = std::make_shared<Panorama>();
    panorama->width = 4;
    panorama->height = 2;
    panorama->radiance.assign(8, Spectrum(1.f));
    scene.environment_image = EnvironmentImage{panorama};
    CHECK(same_bytes(plain, render(scene, 0, {}).image));
    // Light from one side alone reaches the probes too.
    panorama->radiance.assign(8, Spectrum(0.f));
    CHECK(mean(render(scene, 0, {}).image, "indirect") < mean(plain, "indirect"));
}
