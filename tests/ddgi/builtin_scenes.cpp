// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include "ddgi/render.h"
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
        REQUIRE(std::ranges::equal(cached.distance, fresh.distance));
        for (std::size_t i = 0; i < cached.size(); ++i) {
            if (!cached.hit(i)) continue;
            REQUIRE(cached.position[i] == fresh.position[i]);
            REQUIRE(cached.n[i] == fresh.n[i]);
            REQUIRE(cached.direct[i] == fresh.direct[i]);
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
