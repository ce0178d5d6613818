// SPDX-License-Identifier: Apache-2.0
#include <tbb/global_control.h>

#include <catch2/catch.hpp>

#include "ddgi/render.h"
#include "ddgi/volume.h"
#include "scenes/errors.h"
#include "tests/ddgi/small_scenes.h"

using namespace plumbline;
using namespace plumbline::ddgi;

namespace {

DdgiOptions options_for(const std::string& model) {
    DdgiOptions options;
    options.model = model;
    return options;
}

DdgiResult render_on(std::size_t threads, const DdgiOptions& options) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return render(room_with_moving_block(), 5, options);
}

}  // namespace

TEST_CASE("the picture is the same bytes at any number of threads", "[ddgi]") {
    const auto model = GENERATE(as<std::string>(), "conserving", "thesis");
    const DdgiOptions options = options_for(model);
    const DdgiResult one = render_on(1, options);
    CHECK(same_bytes(one.image, render_on(2, options).image));
    CHECK(one.figures.shadow_rays == render_on(3, options).figures.shadow_rays);
}

TEST_CASE("the cache changes no byte of any frame, and saves work", "[ddgi]") {
    const auto model = GENERATE(as<std::string>(), "conserving", "thesis");
    const Scene scene = room_with_moving_block();
    DdgiOptions uncached = options_for(model);
    uncached.cache = false;
    ProbeVolume with(scene, options_for(model));
    ProbeVolume without(scene, uncached);
    for (int frame = 0; frame < scene.frames; ++frame) {
        INFO("frame " << frame);
        with.move_to(frame);
        without.move_to(frame);
        CHECK(std::ranges::equal(with.cache().surfels().place, without.cache().surfels().place));
        CHECK(with.figures().surfels_hit == without.figures().surfels_hit);
        with.update();
        without.update();
        CHECK(std::ranges::equal(with.values(), without.values()));
        CHECK(without.figures().replaced == without.figures().surfels);
        const bool moving = frame > 2 && frame <= 6;
        if (frame == 0) {
            CHECK(with.figures().replaced == with.figures().surfels);
        } else if (moving) {
            CHECK(with.figures().replaced > 0);
            CHECK(with.figures().replaced < with.figures().surfels);
            CHECK(with.figures().surfel_shadow_rays < without.figures().surfel_shadow_rays);
        } else {
            CHECK(with.figures().replaced == 0);
            CHECK(with.figures().surfel_shadow_rays == 0);
        }
    }
    CHECK(same_bytes(render(scene, 5, options_for(model)).image, render(scene, 5, uncached).image));
}

TEST_CASE("a frame's time is that of its steps, and once settled at rest it takes none", "[ddgi]") {
    const Scene scene = room_with_moving_block();
    ProbeVolume volume(scene, options_for("conserving"));
    volume.move_to(3);
    volume.update();
    const int moving = 4;
    volume.move_to(moving);
    volume.converge();
    const FrameFigures& figures = volume.figures();
    for (const TimedStep& step : timed_steps) {
        INFO(step.name);
        CHECK(figures.steps.*step.ms > 0.);
    }
    CHECK(figures.place_ms == figures.steps.placing());
    CHECK(figures.light_ms == figures.steps.lighting());

    for (int i = 0; i < most_updates && figures.relative_change > 0.; ++i) volume.update();
    volume.move_to(moving);
    volume.update();
    for (const TimedStep& step : timed_steps) {
        INFO(step.name);
        CHECK(figures.steps.*step.ms == 0.);
    }
}

TEST_CASE("with every storage and weights the cache changes no byte of any frame", "[ddgi]") {
    const Scene scene = room_with_moving_block();
    DdgiOptions cached = options_for("conserving");
    cached.probes = GENERATE(from_range(all_probe_options()));
    DdgiOptions uncached = cached;
    uncached.cache = false;
    ProbeVolume with(scene, cached);
    ProbeVolume without(scene, uncached);
    for (int frame = 0; frame < scene.frames; ++frame) {
        with.move_to(frame);
        without.move_to(frame);
        with.update();
        without.update();
        REQUIRE(std::ranges::equal(with.values(), without.values()));
    }
}

TEST_CASE("pixels on edges are sampled finely if asked for and no others are", "[ddgi]") {
    const Scene scene = room_with_moving_block();
    DdgiOptions options = options_for("conserving");
    options.gi = false;
    const DdgiResult fine = render(scene, 0, options);
    options.edge_samples = 4;
    const DdgiResult coarse = render(scene, 0, options);
    std::size_t changed = 0;
    for (std::size_t i = 0; i < fine.image.pixels(); ++i) {
        if (fine.image.channel("R")[i] != coarse.image.channel("R")[i]) ++changed;
    }
    CHECK(changed > 0);
    CHECK(changed < fine.image.pixels() / 2);
    options.edge_samples = 5;
    CHECK_THROWS_AS(render(scene, 0, options), UsageError);
}

TEST_CASE("a still is converged, and --updates says how many instead", "[ddgi]") {
    const Scene scene = room_with_moving_block();
    DdgiOptions options = options_for("conserving");
    const DdgiResult still = render(scene, 9, options);
    CHECK(still.figures.converged);
    CHECK(still.figures.relative_change < 1e-4);
    options.updates = 1;
    const DdgiResult moving = render(scene, 4, options);
    CHECK(moving.figures.updates == 1);
    CHECK_FALSE(moving.figures.converged);
    options.updates = 0;
    CHECK(mean(render(scene, 0, options).image, "indirect") == 0.);
}

TEST_CASE("once an update changes no bit the next are skipped, and change none", "[ddgi]") {
    Scene scene = room_with_moving_block();
    ProbeVolume volume(scene, options_for("conserving"));
    volume.move_to(7);
    for (int i = 0; i < 300; ++i) volume.update();
    const std::vector<float> settled(volume.values().begin(), volume.values().end());
    std::vector<float> again(settled.size());
    volume.model().update(settled, again);
    CHECK(again == settled);
    CHECK(volume.figures().relative_change == 0.);
}

TEST_CASE("an update reads the last values alone, whatever the next held", "[ddgi]") {
    const auto model = GENERATE(as<std::string>(), "conserving", "thesis");
    const Scene scene = room_with_moving_block();
    ProbeVolume volume(scene, options_for(model));
    volume.move_to(0);
    volume.update();
    const std::vector<float> previous(volume.values().begin(), volume.values().end());
    std::vector<float> into_zeros(previous.size(), 0.f);
    std::vector<float> into_noise(previous.size(), 1e6f);
    volume.model().update(previous, into_zeros);
    volume.model().update(previous, into_noise);
    CHECK(into_zeros == into_noise);
    CHECK(std::ranges::equal(previous, volume.values()));
}

TEST_CASE("without global illumination there is direct light, the thesis's ambient, and no probe",
          "[ddgi]") {
    const Scene scene = room_with_moving_block();
    DdgiOptions options = options_for("conserving");
    const DdgiResult lit = render(scene, 3, options);
    options.gi = false;
    const DdgiResult direct = render(scene, 3, options);
    CHECK(direct.figures.probes == 0);
    CHECK(direct.figures.replaced == 0);
    CHECK(direct.figures.surfel_shadow_rays == 0);
    CHECK_FALSE(direct.image.has_layer("indirect"));
    CHECK(std::ranges::equal(direct.image.layer("")[0], lit.image.layer("direct")[0]));
    CHECK(std::ranges::equal(direct.image.layer("direct")[1], lit.image.layer("direct")[1]));

    options.model = "thesis";
    const DdgiResult thesis = render(scene, 3, options);
    for (std::size_t i = 0; i < thesis.image.pixels(); ++i) {
        CHECK(thesis.image.layer("")[0][i] ==
              Approx(thesis.image.layer("direct")[0][i] + .07f * thesis.image.layer("albedo")[0][i])
                  .epsilon(1e-5));
    }
}

TEST_CASE("more shadow rays to a light without size change nothing but the count", "[ddgi]") {
    const Scene scene = room_with_moving_block();
    DdgiOptions options = options_for("conserving");
    const DdgiResult one = render(scene, 0, options);
    options.shadow_rays = 3;
    const DdgiResult three = render(scene, 0, options);
    CHECK(same_bytes(one.image, three.image));
    const auto picture_rays = [](const DdgiResult& result) {
        return result.figures.shadow_rays - result.figures.surfel_shadow_rays;
    };
    CHECK(picture_rays(three) == 3 * picture_rays(one));
}

TEST_CASE("values that are not finite are counted and located", "[ddgi]") {
    Scene scene = room_with_moving_block();
    scene.objects.erase(scene.objects.begin() + 1);  // the wall at x = 1
    DdgiOptions options = options_for("thesis");
    // Each ray that is missed there brings a thousandfold of what its probe held itself.
    options.set = {{"falloffRegulator", 1e3}};
    const DdgiResult result = render(scene, 0, options);
    CHECK_FALSE(result.figures.converged);
    CHECK(result.figures.non_finite > 0);
    REQUIRE_FALSE(result.notes.empty());
    CHECK_THAT(result.notes.back(), Catch::Contains("not finite, the first at pixel ("));
}

TEST_CASE("what does not exist is refused, with what does", "[ddgi]") {
    const Scene scene = room_with_moving_block();
    CHECK_THROWS_WITH(render(scene, 0, options_for("theses")),
                      Catch::Contains("thesis") && Catch::Contains("conserving"));
    DdgiOptions options = options_for("conserving");
    options.set = {{"ambient", .1}};
    CHECK_THROWS_WITH(render(scene, 0, options), Catch::Contains("no constants"));
    options = options_for("thesis");
    options.surfels = 72;
    CHECK_THROWS_AS(render(scene, 0, options), UsageError);
    options = options_for("thesis");
    options.spacing = 2.f;
    CHECK_THROWS_WITH(render(scene, 0, options), Catch::Contains("three probes"));
    options = options_for("conserving");
    options.shadow_rays = 0;
    CHECK_THROWS_AS(render(scene, 0, options), UsageError);
    options = options_for("conserving");
    options.updates = -1;
    CHECK_THROWS_AS(render(scene, 0, options), UsageError);
}
