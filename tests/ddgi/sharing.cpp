// SPDX-License-Identifier: Apache-2.0
#include <tbb/global_control.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <glm/gtc/constants.hpp>
#include <limits>
#include <span>

#include "ddgi/surfel_cells.h"
#include "ddgi/volume.h"
#include "scenes/errors.h"
#include "tests/ddgi/small_scenes.h"

using namespace plumbline;
using namespace plumbline::ddgi;

namespace {

DdgiOptions with_share(double share, const std::string& model = "conserving") {
    DdgiOptions options;
    options.model = model;
    options.share = share;
    return options;
}

/// Every model whose surfels take in what probes hold, and every way to gather it.
std::vector<DdgiOptions> all_models(double share) {
    std::vector<DdgiOptions> all;
    for (const char* model : {"conserving", "thesis", "steps", "irradiance"})
        all.push_back(with_share(share, model));
    all[1].set["multiBounceIntensity"] = 1.;
    all[2].set = {{"solidAngle", 1.}, {"firstSurface", 1.}, {"multiBounce", 1.}};
    for (const ProbeOptions& probes :
         {ProbeOptions{.storage = Storage::Octants}, ProbeOptions{.feedback = Feedback::Rays},
          ProbeOptions{.weights = ProbeWeights::Moments, .skip_inside = true}}) {
        all.push_back(with_share(share));
        all.back().probes = probes;
    }
    return all;
}

struct Place {
    glm::vec3 position;
    glm::vec3 n;
};

Surfels surfels_at(const std::vector<Place>& places) {
    Surfels surfels;
    surfels.resize(1, static_cast<int>(places.size()));
    surfels.source.resize(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        surfels.place[i].distance = 1.f;
        surfels.place[i].position = places[i].position;
        surfels.place[i].n = places[i].n;
    }
    return surfels;
}

}  // namespace

TEST_CASE("surfels of one cell show the light of the one nearest to its middle", "[share]") {
    const glm::vec3 up(0.f, 1.f, 0.f);
    const glm::vec3 right(1.f, 0.f, 0.f);
    Surfels surfels = surfels_at({{{.1f, 0.f, .1f}, up},
                                  {{.4f, 0.f, .6f}, up},  // nearest to (.5, .5, .5)
                                  {{.9f, 0.f, .1f}, up},
                                  {{.5f, .0f, .5f}, right},  // faces another way
                                  {{1.1f, 0.f, .5f}, up},    // in the next cell
                                  {{-.1f, 0.f, .5f}, up},    // in the one before
                                  {{.6f, 0.f, .4f}, up},     // as near as the second
                                  {{.5f, 0.f, .5f}, glm::normalize(glm::vec3(.05f, 1.f, 0.f))}});
    surfels.place[6].distance = std::numeric_limits<float>::infinity();
    SurfelCells cells(1., surfels.size());
    CHECK(cells.group(surfels) == 4);
    // The last one faces nearly up, and is the nearest.
    CHECK(surfels.source[0] == 7);
    CHECK(surfels.source[1] == 7);
    CHECK(surfels.source[2] == 7);
    CHECK(surfels.source[3] == 3);
    CHECK(surfels.source[4] == 4);
    CHECK(surfels.source[5] == 5);
    surfels.place[7].distance = std::numeric_limits<float>::infinity();
    surfels.place[6].distance = 1.f;
    CHECK(cells.group(surfels) == 4);
    CHECK(surfels.source[0] == 1);  // of two as near, the first
    CHECK(surfels.source[6] == 1);
}

TEST_CASE("light is measured once a cell, and all that share it show it", "[share]") {
    const Scene scene = room_with_moving_block();
    ProbeVolume own(scene, with_share(0.));
    ProbeVolume shared(scene, with_share(.5));
    own.move_to(0);
    shared.move_to(0);
    CHECK(own.figures().surfels_lit == own.figures().surfels_hit);
    CHECK(shared.figures().surfels_hit == own.figures().surfels_hit);
    CHECK(shared.figures().surfels_lit < own.figures().surfels_hit / 2);
    CHECK(shared.figures().surfel_shadow_rays < own.figures().surfel_shadow_rays / 2);
    const Surfels& surfels = shared.cache().surfels();
    const float width = .5f * shared.cache().grid().spacing;
    std::uint64_t lit = 0;
    for (std::size_t i = 0; i < surfels.size(); ++i) {
        if (!surfels.hit(i)) continue;
        lit += surfels.own_light(i) ? 1 : 0;
        const std::size_t source = surfels.source_of(i);
        REQUIRE(surfels.own_light(source));
        REQUIRE(surfels.light[i].direct == surfels.light[source].direct);
        REQUIRE(glm::distance(surfels.place[i].position, surfels.place[source].position) <
                width * glm::root_three<float>());
        REQUIRE(glm::dot(surfels.place[i].n, surfels.place[source].n) > .9f);
    }
    CHECK(lit == shared.figures().surfels_lit);
    CHECK(shared.figures().surfel_shadow_rays <= lit);  // one lamp
}

TEST_CASE("in cells too small to share every byte is as without", "[share]") {
    const Scene scene = room_with_moving_block();
    DdgiOptions options = GENERATE(from_range(all_models(1e-12)));
    INFO(options.model);
    ProbeVolume tiny(scene, options);
    options.share = 0.;
    ProbeVolume none(scene, options);
    for (int frame = 0; frame < scene.frames; ++frame) {
        for (ProbeVolume* volume : {&tiny, &none}) {
            volume->move_to(frame);
            volume->update();
        }
        REQUIRE(std::ranges::equal(tiny.values(), none.values()));
    }
}

TEST_CASE("with shared light the cache changes no byte of any frame", "[share]") {
    const Scene scene = room_with_moving_block();
    DdgiOptions options = GENERATE(from_range(all_models(.4)));
    INFO(options.model);
    ProbeVolume with(scene, options);
    options.cache = false;
    ProbeVolume without(scene, options);
    for (int frame = 0; frame < scene.frames; ++frame) {
        for (ProbeVolume* volume : {&with, &without}) {
            volume->move_to(frame);
            volume->update();
        }
        REQUIRE(same_surfels(with.cache().surfels(), without.cache().surfels()));
        REQUIRE(std::ranges::equal(with.values(), without.values()));
        CHECK(with.figures().surfels_lit == without.figures().surfels_lit);
    }
}

TEST_CASE("with shared light the picture is the same bytes at any number of threads", "[share]") {
    const auto on = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return render(room_with_moving_block(), 5, with_share(.4));
    };
    const DdgiResult one = on(1);
    CHECK(same_bytes(one.image, on(2).image));
    CHECK(same_bytes(one.image, on(3).image));
}

TEST_CASE("furnace: where all is equally bright shared light is exact", "[share][analytic]") {
    const Spectrum rho(.5f, .8f, 0.f);
    const Spectrum Le(1.f, .25f, 2.f);
    DdgiOptions options = with_share(GENERATE(.3, 5.));
    options.probes.storage = GENERATE(Storage::Rays, Storage::Octants, Storage::Octahedral);
    const DdgiResult result = render(closed_room(rho, Le), 0, options);
    CHECK(result.figures.converged);
    CHECK(result.figures.surfels_lit < result.figures.surfels_hit);
    for (int c = 0; c < 3; ++c) {
        const double expected = double(Le[c]) / (1. - double(rho[c]));
        const std::span<const float> values = result.image.layer("")[static_cast<std::size_t>(c)];
        REQUIRE(!values.empty());
        CHECK(std::ranges::all_of(
            values, [&](float value) { return value == Approx(expected).epsilon(1e-3); }));
    }
}

TEST_CASE("integrating sphere: shared light keeps the energy in the mean", "[share][analytic]") {
    const float rho = .8f;
    const double expected = double(rho) / glm::pi<double>() / 4. * double(rho) / (1. - double(rho));
    const Scene sphere = integrating_sphere(rho, {.4f, .7f, -.2f});
    const double share = GENERATE(.25, .5);
    CHECK(mean(render(sphere, 0, with_share(share)).image, "indirect") ==
          Approx(expected).epsilon(.03));
}

TEST_CASE("widths of cells that are no widths are refused", "[share]") {
    const Scene scene = room_with_moving_block();
    for (const double share :
         {-1., std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
        CHECK_THROWS_WITH(render(scene, 0, with_share(share)), Catch::Contains("--share"));
}
