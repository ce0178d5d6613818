// SPDX-License-Identifier: Apache-2.0
#include "ddgi/spectral_radius.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/ddgi/small_scenes.h"

using namespace plumbline;
using namespace plumbline::ddgi;

namespace {

struct Placed {
    Scene scene;
    DdgiOptions options;
    ProbeVolume volume;

    Placed(Scene from, const std::string& model, double multi_bounce)
        : scene(std::move(from)), options(of(model, multi_bounce)), volume(scene, options) {
        volume.move_to(0);
    }

    SpectralRadius radius(std::vector<float>& mode) const {
        return spectral_radius(volume.model(), probe_count(volume.cache().grid()),
                               volume.values().size(), mode);
    }
    double radius() const {
        std::vector<float> mode;
        return radius(mode).value;
    }

 private:
    static DdgiOptions of(const std::string& model, double multi_bounce) {
        DdgiOptions options;
        options.model = model;
        if (model == "thesis") options.set = {{"multiBounceIntensity", multi_bounce}};
        return options;
    }
};

/// How much the largest value grows, or shrinks, over `updates` updates from `values` on.
double growth(const ProbeModel& model, std::vector<float> values, int updates) {
    const float before = *std::ranges::max_element(values);
    std::vector<float> next(values.size());
    for (int i = 0; i < updates; ++i) {
        model.update(values, next);
        values.swap(next);
    }
    return double(*std::ranges::max_element(values)) / double(before);
}

}  // namespace

TEST_CASE("in a closed room of one albedo the radius of conserving is the albedo",
          "[ddgi][analytic]") {
    const auto rho = GENERATE(.25f, .7f, .95f);
    // A constant field is the mode: sum_d W_d = pi for every normal, and weights sum to one.
    std::vector<float> mode;
    const Placed room(closed_room(Spectrum(rho), Spectrum(1.f)), "conserving", 0.);
    const SpectralRadius radius = room.radius(mode);
    CHECK(radius.settled);
    CHECK(radius.value == Approx(rho).epsilon(2e-5));
    for (const float value : mode) REQUIRE(value == Approx(1.f).epsilon(1e-3));
}

TEST_CASE("conserving contracts by the largest albedo, or faster", "[ddgi]") {
    const Placed room(room_with_moving_block(), "conserving", 0.);
    CHECK(room.radius() < .9);  // the largest albedo of any channel in this scene
    CHECK(room.radius() > .2);
    CHECK_FALSE(critical_multi_bounce(room.scene, room.volume, room.options).has_value());
}

TEST_CASE("the thesis's feedback dies below the critical intensity and grows above it", "[ddgi]") {
    Scene scene = room_with_moving_block();
    const Placed strong(scene, "thesis", 1e3);
    REQUIRE(strong.radius() > 1.);
    const double critical =
        critical_multi_bounce(strong.scene, strong.volume, strong.options).value();
    // Without light every value comes from feedback alone.
    scene.lights.clear();
    const double share = GENERATE(.999, 1.001);
    const Placed near(scene, "thesis", critical * share);
    std::vector<float> mode;
    const SpectralRadius radius = near.radius(mode);
    CHECK(radius.value == Approx(1.).margin(2e-3));
    // From a faint start, for the clamp at a surfel's radiance of 1 hides growth.
    for (float& value : mode) value *= 1e-3f;
    constexpr int updates = 400;
    const double grown = growth(near.volume.model(), mode, updates);
    CHECK(grown == Approx(std::pow(radius.value, updates)).epsilon(.02));
    CHECK((grown < 1.) == (share < 1.));
}

TEST_CASE("above the critical intensity the probes end in light that no light gives", "[ddgi]") {
    Scene scene = room_with_moving_block();
    const Placed lit(scene, "thesis", 1e3);
    const double critical = critical_multi_bounce(lit.scene, lit.volume, lit.options).value();
    scene.lights[0].white_radiance = Spectrum(1e-6f);
    const auto brightest_after = [&](double intensity) {
        Placed room(scene, "thesis", intensity);
        for (int i = 0; i < 1000; ++i) room.volume.update();
        return *std::ranges::max_element(room.volume.values());
    };
    CHECK(brightest_after(.9 * critical) < 1e-5f);
    CHECK(brightest_after(1.1 * critical) > 1e-2f);
}

TEST_CASE("a render reports the radius and warns with the critical intensity", "[ddgi]") {
    const Scene scene = room_with_moving_block();
    DdgiOptions options;
    options.model = "thesis";
    options.updates = 1;
    options.spectral_radius = true;
    const DdgiResult published = render(scene, 0, options);
    CHECK(published.spectral_radius.value() < 1.);
    CHECK_FALSE(published.critical_multi_bounce.has_value());
    options.set = {{"multiBounceIntensity", 1e3}};
    const DdgiResult strong = render(scene, 0, options);
    CHECK(strong.spectral_radius.value() > 1.);
    CHECK(strong.critical_multi_bounce.value() < 1e3);
    CHECK_THAT(strong.notes.back(), Catch::Contains("keep multiBounceIntensity below"));
}
