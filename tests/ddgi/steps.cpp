// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "ddgi/look_up.h"
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

TEST_CASE("in an empty grid light passes on whole but for what leaves it",
          "[ddgi][steps][analytic]") {
    Scene scene = closed_room(Spectrum(.5f), Spectrum(0.f));
    scene.objects.resize(1);  // a wall that no ray of one cell reaches
    scene.probes = ProbeGrid{glm::vec3(0.f), .1f, {7, 7, 7}};
    const std::string rule = GENERATE("diagonalNeighbour", "gridAtEnd");
    ProbeVolume volume(scene, steps({"solidAngle", "octantLookUp", "evenRays", rule}));
    volume.move_to(0);
    REQUIRE(volume.figures().surfels_hit == 0);
    const std::vector<float> ones(volume.values().size(), 1.f);
    std::vector<float> next(ones.size());
    volume.model().update(ones, next);
    for (std::uint32_t probe = 0; probe < 343; ++probe) {
        const glm::ivec3 cell = probe_cell(*scene.probes, probe);
        for (std::size_t d = 0; d < octant_count; ++d) {
            const glm::ivec3 neighbour = cell + principal_directions[d];
            const bool stays = glm::all(glm::greaterThanEqual(neighbour, glm::ivec3(0))) &&
                               glm::all(glm::lessThan(neighbour, glm::ivec3(7)));
            const bool middle = glm::all(glm::greaterThan(cell, glm::ivec3(0))) &&
                                glm::all(glm::lessThan(cell, glm::ivec3(6)));
            const float passed = next[value_index(probe, 1, d, octant_count)];
            if (rule == "diagonalNeighbour") REQUIRE(passed == Approx(stays ? 1.f : 0.f));
            if (rule == "gridAtEnd" && middle) REQUIRE(passed == Approx(1.f));
            REQUIRE(passed <= 1.f + 1e-5f);
        }
    }
}

TEST_CASE("the grid where a ray ends is read between its probes", "[ddgi][steps][analytic]") {
    Scene scene = closed_room(Spectrum(.5f), Spectrum(0.f));
    scene.objects.resize(1);
    scene.probes = ProbeGrid{glm::vec3(0.f), .1f, {5, 5, 5}};
    ProbeVolume volume(scene, steps({"solidAngle", "octantLookUp", "evenRays", "gridAtEnd"}));
    volume.move_to(0);
    // Where the values are linear in y, the octant brings the value at its rays' mean end.
    std::vector<float> linear(volume.values().size());
    for (std::uint32_t probe = 0; probe < 125; ++probe)
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t d = 0; d < octant_count; ++d)
                linear[value_index(probe, c, d, octant_count)] =
                    float(probe_cell(*scene.probes, probe).y);
    std::vector<float> next(linear.size());
    volume.model().update(linear, next);
    const std::uint32_t middle = probe_index(*scene.probes, {2, 2, 2});
    const RayPattern pattern = even_pattern(64);
    for (std::size_t d = 0; d < octant_count; ++d) {
        double end = 0.;
        for (std::size_t ray = d * 8; ray < (d + 1) * 8; ++ray) {
            const glm::vec3 w = pattern.directions[ray];
            end += double(w.y / max_component(glm::abs(w))) / 8.;
        }
        CHECK(next[value_index(middle, 0, d, octant_count)] == Approx(2. + end).epsilon(1e-4));
    }
}

TEST_CASE("a step that does not exist is refused and so is half a step", "[ddgi][steps]") {
    const Scene scene = room_with_moving_block();
    CHECK_THROWS_WITH(render(scene, 0, steps({"solidAngel"})), Catch::Contains("solidAngle"));
    DdgiOptions options = steps({});
    options.set = {{"solidAngle", .5}};
    CHECK_THROWS_AS(render(scene, 0, options), UsageError);
}
