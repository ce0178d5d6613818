// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "ddgi/volume.h"
#include "scenes/errors.h"
#include "tests/ddgi/small_scenes.h"

using namespace plumbline;
using namespace plumbline::ddgi;

namespace {

const std::vector<std::string> all_steps{"receiverAlbedo", "solidAngle",   "octantLookUp",
                                         "evenRays",       "firstSurface", "multiBounce"};

DdgiOptions steps(const std::vector<std::string>& taken) {
    DdgiOptions options;
    options.model = "steps";
    for (const std::string& name : taken) options.set[name] = 1;
    options.updates = 5;
    return options;
}

double largest_difference(const Image& a, const Image& b, const std::string& layer) {
    double largest = 0.;
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t i = 0; i < a.pixels(); ++i)
            largest = std::max(
                largest, std::abs(double(a.layer(layer)[c][i]) - double(b.layer(layer)[c][i])));
    return largest;
}

}  // namespace

TEST_CASE("with no step taken the model is the thesis's", "[ddgi][steps]") {
    const Scene scene = room_with_moving_block();
    DdgiOptions thesis;
    thesis.model = "thesis";
    thesis.updates = 5;
    const Image expected = render(scene, 4, thesis).image;
    REQUIRE(mean(expected, "indirect") > 0.);
    CHECK(largest_difference(expected, render(scene, 4, steps({})).image, "indirect") < 1e-5);
    // The published feedback is a step too.
    thesis.set = {{"multiBounceIntensity", 5.4}};
    CHECK(largest_difference(render(scene, 4, thesis).image,
                             render(scene, 4, steps({"multiBounce"})).image, "indirect") < 1e-5);
}

TEST_CASE("each step changes the picture, alone and on the road", "[ddgi][steps]") {
    const Scene scene = room_with_moving_block();
    const Image none = render(scene, 4, steps({})).image;
    std::vector<std::string> taken;
    Image before = none;
    for (const std::string& step : all_steps) {
        CAPTURE(step);
        CHECK(largest_difference(none, render(scene, 4, steps({step})).image, "indirect") > 1e-5);
        taken.push_back(step);
        Image now = render(scene, 4, steps(taken)).image;
        CHECK(largest_difference(before, now, "indirect") > 1e-5);
        before = now;
    }
}

TEST_CASE("with all steps taken a dark closed room scatters an even field by its albedo",
          "[ddgi][steps][analytic]") {
    // Each ray brings rho / pi times the sum of W_d, which is pi for every normal.
    const Scene scene = closed_room(Spectrum(.6f), Spectrum(0.f));
    ProbeVolume volume(scene, steps(all_steps));
    volume.move_to(0);
    const std::vector<float> ones(volume.values().size(), 1.f);
    std::vector<float> next(ones.size());
    volume.model().update(ones, next);
    for (const float value : next) REQUIRE(value == Approx(.6f).epsilon(1e-5));
}

TEST_CASE("a step that does not exist is refused and so is half a step", "[ddgi][steps]") {
    const Scene scene = room_with_moving_block();
    CHECK_THROWS_WITH(render(scene, 0, steps({"solidAngel"})), Catch::Contains("solidAngle"));
    DdgiOptions options = steps({});
    options.set = {{"solidAngle", .5}};
    CHECK_THROWS_AS(render(scene, 0, options), UsageError);
}
