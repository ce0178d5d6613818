// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include "ddgi/render.h"
#include "ddgi/seen_probes.h"
#include "ddgi/volume.h"
#include "scenes/scene_files.h"
#include "tests/ddgi/small_scenes.h"

using namespace plumbline;
using namespace plumbline::ddgi;

namespace {

/// Four frames out of the middle of the built-in animations, on a coarse grid.
constexpr int first_frame = 260;
constexpr int last_frame = 263;

DdgiOptions coarse(const std::string& model, bool cache) {
    DdgiOptions options;
    options.model = model;
    options.spacing = 50.f;
    options.cache = cache;
    return options;
}

}  // namespace

TEST_CASE("in the built-in animations the cache changes no byte", "[ddgi]") {
    const auto name = GENERATE(as<std::string>(), "cornell-box", "room-with-door");
    const auto model = GENERATE(as<std::string>(), "conserving", "thesis");
    const Scene scene = load_scene(name);
    ProbeVolume with(scene, coarse(model, true));
    ProbeVolume without(scene, coarse(model, false));
    for (int frame = first_frame; frame <= last_frame; ++frame) {
        INFO(name << ", " << model << ", frame " << frame);
        with.move_to(frame);
        without.move_to(frame);
        const Surfels& cached = with.cache().surfels();
        const Surfels& fresh = without.cache().surfels();
        REQUIRE(std::ranges::equal(cached.place, fresh.place));
        REQUIRE(std::ranges::equal(cached.object, fresh.object));
        REQUIRE(std::ranges::equal(cached.light, fresh.light));
        for (std::size_t i = 0; i < cached.seen.size(); ++i) {
            if (cached.hit(i)) REQUIRE(cached.seen[i] == fresh.seen[i]);
        }
        with.update();
        without.update();
        REQUIRE(std::ranges::equal(with.values(), without.values()));
        if (frame > first_frame) {
            CHECK(with.figures().replaced > 0);
            CHECK(with.figures().replaced < without.figures().replaced);
        }
    }
}

TEST_CASE("hardly more rays are traced anew than those that tracing all afresh would end elsewhere",
          "[ddgi]") {
    const auto name = GENERATE(as<std::string>(), "cornell-box", "room-with-door");
    const Scene scene = load_scene(name);
    ProbeVolume volume(scene, coarse("conserving", true));
    ProbeVolume afresh(scene, coarse("conserving", false));
    volume.move_to(first_frame);
    std::uint64_t traced = 0;
    std::uint64_t replaced = 0;
    std::uint64_t changed = 0;
    for (int frame = first_frame + 1; frame <= last_frame + 4; ++frame) {
        const Surfels before = volume.cache().surfels();
        volume.move_to(frame);
        afresh.move_to(frame);
        traced += volume.cache().figures().traced;
        replaced += volume.figures().replaced;
        const Surfels& after = afresh.cache().surfels();
        for (std::size_t i = 0; i < before.size(); ++i) {
            const bool same_end = before.place[i] == after.place[i] &&
                                  before.object[i] == after.object[i] &&
                                  before.light[i].albedo == after.light[i].albedo;
            if (!same_end) ++changed;
        }
    }
    CAPTURE(traced, replaced, changed);
    CHECK(changed > 0);
    CHECK(replaced >= changed);
    CHECK(double(traced) <= 1.3 * double(changed));
}

TEST_CASE("once light has settled a frame in which nothing moves takes no work", "[ddgi]") {
    const auto name = GENERATE(as<std::string>(), "cornell-box", "room-with-door");
    const auto model = GENERATE(as<std::string>(), "conserving", "thesis");
    const Scene scene = load_scene(name);
    constexpr int at_rest = 360;
    ProbeVolume volume(scene, coarse(model, true));
    volume.move_to(at_rest);
    // Light shrinks by the albedo, .7 on average, from one update to the next: the bits of a float
    // are spent after 24 log 2 / log(1 / .7), 47.
    constexpr int enough = 120;
    int updates = 0;
    do {
        volume.update();
    } while (volume.figures().relative_change != 0. && ++updates < enough);
    INFO(name << ", " << model << " after " << updates);
    CHECK(updates < enough);
    const std::vector<float> settled(volume.values().begin(), volume.values().end());
    std::vector<float> again(settled.size());
    volume.model().update(settled, again);
    CHECK(again == settled);
    for (int frame = at_rest + 1; frame < at_rest + 4; ++frame) {
        volume.move_to(frame);
        volume.update();
        CHECK(volume.figures().replaced == 0);
        CHECK(volume.figures().surfel_shadow_rays == 0);
        CHECK(volume.figures().relative_change == 0.);
        for (std::size_t i = 0; i < volume.cache().surfels().size(); ++i) {
            if (volume.cache().changed(i)) FAIL("surfel " << i << " was touched");
        }
    }
    CHECK(std::ranges::equal(volume.values(), settled));
}

TEST_CASE("hardly any light of the lit room reaches the dark one through a thin wall", "[ddgi]") {
    Scene scene = load_scene("two-rooms");
    scene.camera.width = 96;
    scene.camera.height = 54;
    const World world = world_at(scene, 0);
    const float spacing = probe_grid(scene).spacing;
    INFO("the wall is .05 thick, a cell " << spacing);
    DdgiOptions options;
    const auto rooms = [&](ProbeWeights weights) {
        options.probes.weights = weights;
        ProbeVolume volume(scene, options);
        volume.move_to(0);
        volume.converge();
        const auto light_at = [&](const glm::vec3& x) {
            ReceiverPoint point{x, {0.f, 1.f, 0.f}, Spectrum(1.f)};
            point.seen =
                seen_probes(volume.tracer(), volume.cache().grid(), point.position, point.n);
            return double(volume.model().probe_light(volume.values(), point).g);
        };
        double lit = 0.;
        double dark = 0.;
        for (int i = 0; i < 20; ++i) {
            for (int j = 0; j < 10; ++j) {
                const float x = .05f + .19f * float(i);
                const float z = -1.9f + .4f * float(j);
                lit += light_at({-x, .001f, z});
                dark += light_at({x, .001f, z});
            }
        }
        return dark / lit;
    };
    CHECK(rooms(ProbeWeights::Visibility) < .01);
    CHECK(rooms(ProbeWeights::None) > .01);  // the leak that the weights stop is there
}

TEST_CASE("at their published constants the thesis's scenes are lit, converge and stay finite",
          "[ddgi]") {
    const auto name = GENERATE(as<std::string>(), "cornell-box", "room-with-door");
    Scene scene = load_scene(name);
    scene.camera.width = 48;
    scene.camera.height = 27;
    DdgiOptions options;
    options.model = "thesis";
    const DdgiResult result = render(scene, 0, options);
    CHECK(result.figures.converged);
    CHECK(result.figures.non_finite == 0);
    CHECK(result.notes.empty());
    CHECK(result.figures.probes == (name == "cornell-box" ? 9261 : 5292));
    CHECK(mean(result.image, "indirect") > 0.);
    CHECK(mean(result.image, "ambient") > 0.);
}
