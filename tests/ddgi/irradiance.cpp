// SPDX-License-Identifier: Apache-2.0
#include <tbb/global_control.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "ddgi/irradiance_model.h"
#include "ddgi/render.h"
#include "ddgi/spectral_radius.h"
#include "ddgi/volume.h"
#include "scenes/errors.h"
#include "tests/ddgi/small_scenes.h"

using namespace plumbline;
using namespace plumbline::ddgi;

namespace {

using Set = std::map<std::string, double>;

DdgiOptions irradiance(const Set& set) {
    DdgiOptions options;
    options.model = "irradiance";
    options.set = set;
    return options;
}

/// The settings that leave every look-up a convex mean.
const std::vector<Set> convex{{},
                              {{"wrapShading", 1}, {"crushThreshold", .2}},
                              {{"normalBias", .045}, {"viewBias", .18}, {"visibilityPower", 3}},
                              {{"chebyshev", 0}},
                              {{"skipInside", 1}, {"blackBacks", 1}, {"leastVisibility", .05}},
                              {{"depthSharpness", 1}}};

std::vector<float> values_of(const ProbeVolume& volume) {
    return {volume.values().begin(), volume.values().end()};
}

double largest_difference(const std::vector<float>& a, const std::vector<float>& b) {
    double largest = 0.;
    for (std::size_t i = 0; i < a.size(); ++i)
        largest = std::max(largest, std::abs(double(a[i]) - double(b[i])));
    return largest;
}

}  // namespace

TEST_CASE("furnace: probes of irradiance show Le / (1 - rho) at every pixel",
          "[ddgi][irradiance][analytic]") {
    Set set = GENERATE(from_range(convex));
    // A constant field has no transitions that another encoding could darken.
    const double gamma = GENERATE(1., 5.);
    set["perceptualGamma"] = gamma;
    const Spectrum rho(.5f, .8f, 0.f);
    const Spectrum Le(1.f, .25f, 2.f);
    const DdgiResult result = render(closed_room(rho, Le), 0, irradiance(set));
    CHECK(result.figures.converged);
    for (int c = 0; c < 3; ++c) {
        const double expected = double(Le[c]) / (1. - double(rho[c]));
        const double once = double(Le[c]) * (1. + double(rho[c]));
        const auto channel = static_cast<std::size_t>(c);
        for (std::size_t i = 0; i < result.image.pixels(); ++i) {
            // Roots change by less, and so end their still earlier.
            REQUIRE(result.image.layer("")[channel][i] == Approx(expected).epsilon(1e-3 * gamma));
            REQUIRE(result.image.layer("direct")[channel][i] == Approx(once).epsilon(1e-5));
        }
    }
}

TEST_CASE("furnace: what surfels do not take in is lost at every bounce",
          "[ddgi][irradiance][analytic]") {
    const float rho = .7f;
    const Scene room = closed_room(Spectrum(rho), Spectrum(1.f));
    const double expected = 1. + double(rho) / (1. - .95 * double(rho));
    const Set published{{"published", 1}};
    const Image fed_less = render(room, 0, irradiance({{"energyPreservation", .95}})).image;
    for (const float value : fed_less.channel("R"))
        REQUIRE(value == Approx(expected).epsilon(1e-3));
    // All else that was published moves no light in a constant field, though it takes long.
    DdgiOptions few_rays = irradiance(published);
    few_rays.surfels = 16;
    const DdgiResult still = render(room, 0, few_rays);
    CHECK(still.figures.updates == 305);  // log .01 / log(.97 + .03 * .5), rounded up
    for (const float value : still.image.channel("R"))
        REQUIRE(value == Approx(expected).epsilon(.03));
}

TEST_CASE("furnace: few rays serve the sharpest lobes of distance",
          "[ddgi][irradiance][analytic]") {
    DdgiOptions few_rays = irradiance({{"depthSharpness", 1000}});
    few_rays.surfels = GENERATE(8, 16);
    const DdgiResult result = render(closed_room(Spectrum(.5f), Spectrum(1.f)), 0, few_rays);
    for (const float value : result.image.channel("R")) REQUIRE(value == Approx(2.).epsilon(1e-3));
}

TEST_CASE("the radius of irradiance is the albedo, or what memory makes of it",
          "[ddgi][irradiance][analytic]") {
    const double rho = GENERATE(.25, .7);
    const double hysteresis = GENERATE(0., .5);
    const Scene scene = closed_room(Spectrum(float(rho)), Spectrum(1.f));
    ProbeVolume room(scene, irradiance({{"hysteresis", hysteresis}}));
    room.move_to(0);
    room.update();
    room.update();
    std::vector<float> mode;
    const SpectralRadius radius =
        spectral_radius(room.model(), probe_count(room.cache().grid()), room.values().size(), mode);
    CHECK(radius.settled);
    CHECK(radius.value == Approx(hysteresis + (1. - hysteresis) * rho).epsilon(1e-4));
}

TEST_CASE("an update that is not linear has no spectral radius, and says so",
          "[ddgi][irradiance]") {
    DdgiOptions options = irradiance({{"perceptualGamma", 5}});
    options.spectral_radius = true;
    options.updates = 1;
    const DdgiResult result = render(room_with_moving_block(), 0, options);
    CHECK_FALSE(result.spectral_radius.has_value());
    CHECK_THAT(result.notes.back(), Catch::Contains("not linear"));
}

TEST_CASE("updates of irradiance contract by the largest albedo", "[ddgi][irradiance][analytic]") {
    const Scene scene = room_with_moving_block();
    const DdgiOptions options = irradiance(GENERATE(from_range(convex)));
    ProbeVolume settled(scene, options);
    settled.move_to(0);
    for (int i = 0; i < 150; ++i) settled.update();
    const std::vector<float> limit = values_of(settled);
    const double light = *std::ranges::max_element(limit);
    REQUIRE(light > 0.);
    constexpr double largest_albedo = .9;
    constexpr double rounding = 1e-5;
    ProbeVolume volume(scene, options);
    volume.move_to(0);
    double error = light;
    for (int m = 1; m <= 30; ++m) {
        volume.update();
        const double next_error = largest_difference(values_of(volume), limit);
        CHECK(next_error <= largest_albedo * error + rounding * light);
        error = next_error;
    }
}

TEST_CASE("integrating sphere: irradiance is uniform, rho / (1 - rho) of the mean direct",
          "[ddgi][irradiance][analytic]") {
    const float rho = .8f;
    const double expected = double(rho) / glm::pi<double>() / 4. * double(rho) / (1. - double(rho));
    const Image centre = render(integrating_sphere(rho, glm::vec3(0.f)), 0, irradiance({})).image;
    for (const float value : centre.channel("indirect.G"))
        REQUIRE(value == Approx(expected).epsilon(1e-3));
    const Image off = render(integrating_sphere(rho, {.4f, .7f, -.2f}), 0, irradiance({})).image;
    CHECK(mean(off, "indirect") == Approx(expected).epsilon(.02));
}

TEST_CASE("irradiance is the same bytes with and without a cache and at any number of threads",
          "[ddgi][irradiance]") {
    const Set set = GENERATE(Set{}, Set{{"blackBacks", 1}, {"skipInside", 1}, {"hysteresis", .5}},
                             Set{{"published", 1}});
    const Scene scene = room_with_moving_block();
    const DdgiOptions cached = irradiance(set);
    DdgiOptions uncached = cached;
    uncached.cache = false;
    ProbeVolume with(scene, cached);
    ProbeVolume without(scene, uncached);
    for (int frame = 0; frame < scene.frames; ++frame) {
        const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                          std::size_t(frame % 3 + 1));
        with.move_to(frame);
        without.move_to(frame);
        with.update();
        without.update();
        REQUIRE(values_of(with) == values_of(without));
        const bool turns = set.contains("published");
        const bool moving = frame > 2 && frame <= 6;
        const auto all = without.figures().surfels;
        CHECK((with.figures().replaced == all) == (frame == 0 || turns));
        CHECK((with.figures().replaced == 0) == (frame > 0 && !moving && !turns));
    }
}

TEST_CASE("a texel remembers the share of its past that it is asked to", "[ddgi][irradiance]") {
    Scene scene = closed_room(Spectrum(0.f), Spectrum(1.f));
    ProbeVolume volume(scene, irradiance({{"hysteresis", .75}}));
    volume.move_to(0);
    volume.update();
    // The first update has no past to keep: a black start would take many frames to forget.
    for (const float E : volume.values()) REQUIRE(E == Approx(glm::pi<float>()));
    std::vector<float> dark(volume.values().size(), 0.f);
    std::vector<float> next(dark.size());
    volume.update();
    volume.model().update(dark, next);
    for (const float E : next) REQUIRE(E == Approx(.25f * glm::pi<float>()));
}

TEST_CASE("each departure of irradiance changes the picture by itself", "[ddgi][irradiance]") {
    const Scene scene = room_with_moving_block();
    const auto picture = [&](const Set& set) {
        DdgiOptions options = irradiance(set);
        options.updates = 3;
        return render(scene, 4, options).image;
    };
    const Image plain = picture({});
    for (const auto& [name, value] : named(published_irradiance_settings())) {
        const bool as_by_default = named(IrradianceSettings{})[name] == value;
        CAPTURE(name);
        if (name == "skipInside") continue;  // no probe stands in something
        CHECK(same_bytes(plain, picture({{name, value}})) == as_by_default);
    }
    CHECK(mean(picture({{"energyPreservation", .95}}), "indirect") < mean(plain, "indirect"));
    CHECK(mean(picture({{"perceptualGamma", 5}}), "indirect") < mean(plain, "indirect"));
}

TEST_CASE("probes in a block can be left out", "[ddgi][irradiance]") {
    const auto picture = [&](double skip) {
        DdgiOptions options =
            irradiance({{"chebyshev", 0}, {"wrapShading", 1}, {"skipInside", skip}});
        options.spacing = .24f;
        options.updates = 2;
        return render(room_with_moving_block(), 0, options).image;
    };
    CHECK_FALSE(same_bytes(picture(0), picture(1)));
}

TEST_CASE("settings of irradiance that do not exist are refused", "[ddgi][irradiance]") {
    CHECK_THROWS_WITH(irradiance_settings({{"hysterisis", .5}}), Catch::Contains("hysteresis"));
    const auto bad = GENERATE(Set{{"hysteresis", 1}}, Set{{"hysteresis", -.1}},
                              Set{{"published", .5}}, Set{{"depthSharpness", 1.5}},
                              Set{{"wrapShading", 2}}, Set{{"normalBias", std::nan("")}});
    CHECK_THROWS_AS(irradiance_settings(bad), UsageError);
    // What is named beside `published` overrides it.
    const IrradianceSettings mixed = irradiance_settings({{"published", 1}, {"hysteresis", .5}});
    CHECK(mixed.hysteresis == .5);
    CHECK(mixed.perceptualGamma == 5.);
}
