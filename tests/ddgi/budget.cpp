// SPDX-License-Identifier: Apache-2.0
#include <tbb/global_control.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "ddgi/surfel_queue.h"
#include "ddgi/volume.h"
#include "scenes/errors.h"
#include "tests/ddgi/small_scenes.h"

using namespace plumbline;
using namespace plumbline::ddgi;

namespace {

/// The surfels served by a turn in which `marks` were found.
std::set<std::size_t> turn(SurfelQueue& queue, const std::vector<std::uint8_t>& found) {
    SurfelMarks marks(found.size() / 4, 4);
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (found[i] != 0) marks.add(i, found[i]);
    }
    queue.take_turn(marks);
    std::set<std::size_t> served;
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (marks.of(i) != 0) served.insert(i);
    }
    return served;
}

DdgiOptions with_budget(std::optional<int> budget) {
    DdgiOptions options;
    options.budget = budget;
    return options;
}

/// Every way to keep light of which there is a model that keeps surfels.
std::vector<DdgiOptions> all_models(int budget) {
    std::vector<DdgiOptions> all;
    for (const char* model : {"conserving", "thesis", "steps", "irradiance"}) {
        all.push_back(with_budget(budget));
        all.back().model = model;
    }
    all[1].set["multiBounceIntensity"] = 1.;
    all[2].set = {{"solidAngle", 1.}, {"firstSurface", 1.}, {"multiBounce", 1.}};
    all.push_back(with_budget(budget));
    all.back().probes.storage = Storage::Octants;
    all.push_back(with_budget(budget));
    all.back().probes.weights = ProbeWeights::Moments;
    all.back().probes.skip_inside = true;
    return all;
}

std::vector<float> values_of(const ProbeVolume& volume) {
    return {volume.values().begin(), volume.values().end()};
}

std::vector<float> updated(const ProbeVolume& volume, const std::vector<float>& previous) {
    std::vector<float> next(previous.size());
    volume.model().update(previous, next);
    return next;
}

}  // namespace

TEST_CASE("the queue serves what waits longest and changed most, and all in the end", "[budget]") {
    SurfelQueue queue(8, 2);
    CHECK(queue.oldest() == 0);
    // All marks before two of them before one.
    CHECK(turn(queue, {Mark::Lit, 0, all_marks, Mark::Lit | Mark::Seen, Mark::Seen, 0, 0, 0}) ==
          std::set<std::size_t>{2, 3});
    CHECK(queue.waiting() == 2);
    CHECK(queue.oldest() == 1);
    // One thing changed two turns ago counts as much as two now, and less than three.
    CHECK(turn(queue, {0, all_marks, 0, 0, 0, all_marks, Mark::Lit, Mark::Lit}) ==
          std::set<std::size_t>{1, 5});
    CHECK(queue.oldest() == 2);
    CHECK(turn(queue, {0, 0, 0, 0, 0, 0, 0, 0}) == std::set<std::size_t>{0, 4});
    // What was touched again waits since the first time, for all that changed.
    CHECK(turn(queue, {0, 0, 0, 0, 0, 0, Mark::Placed, 0}) == std::set<std::size_t>{6, 7});
    CHECK(queue.waiting() == 0);
    CHECK(turn(queue, {0, 0, 0, 0, 0, 0, 0, 0}).empty());
}

TEST_CASE("among equals the queue serves surfels spread over all", "[budget]") {
    constexpr std::size_t surfels = 4096;
    constexpr std::size_t parts = 16;
    SurfelQueue queue(surfels, int(surfels / 8));
    std::vector<int> served(parts);
    for (const std::size_t surfel : turn(queue, std::vector<std::uint8_t>(surfels, Mark::Lit)))
        ++served[surfel * parts / surfels];
    for (const int count : served) CHECK(count == Approx(surfels / 8 / parts).margin(3));
}

TEST_CASE("a budget is kept, and once all had their turn nothing tells that there was one",
          "[budget]") {
    constexpr int budget = 150;
    const Scene scene = room_with_moving_block();
    DdgiOptions options = GENERATE(from_range(all_models(budget)));
    INFO(options.model);
    ProbeVolume tight(scene, options);
    options.budget = std::nullopt;
    ProbeVolume free(scene, options);
    std::uint64_t most_waiting = 0;
    for (int frame = 0; frame < scene.frames; ++frame) {
        const std::vector<float> direct_before = [&] {
            std::vector<float> all;
            for (const SurfelLight& light : tight.cache().surfels().light) {
                all.push_back(light.direct.r);
            }
            return all;
        }();
        for (ProbeVolume* volume : {&tight, &free}) {
            volume->move_to(frame);
            volume->update();
        }
        most_waiting = std::max(most_waiting, tight.figures().surfels_waiting);
        if (frame == 0) continue;
        std::size_t changed = 0;
        for (std::size_t i = 0; i < direct_before.size(); ++i) {
            if (tight.cache().changed(i)) ++changed;
            // Who is not served stays as it is.
            else
                REQUIRE(tight.cache().surfels().light[i].direct.r == direct_before[i]);
        }
        CHECK(changed <= budget);
        CHECK(tight.figures().replaced <= budget);
    }
    CHECK(most_waiting > 2 * budget);
    // The block rests; frames go by.
    for (int i = 0; tight.figures().surfels_waiting > 0; ++i) {
        REQUIRE(i < 60);
        CHECK(tight.figures().oldest_wait > 1);
        tight.move_to(scene.frames - 1);
        tight.update();
    }
    CHECK(tight.figures().oldest_wait == 0);
    CHECK(same_surfels(tight.cache().surfels(), free.cache().surfels()));
    CHECK(updated(tight, values_of(free)) == updated(free, values_of(free)));
    // From here on both do the same. Their probes came from different values, and of neighbouring
    // floats several may be a fixed point.
    for (int i = 0; i < 120; ++i) {
        tight.update();
        free.update();
    }
    constexpr float rounding = 1e-5f;
    float largest = 0.f;
    for (std::size_t i = 0; i < free.values().size(); ++i)
        largest = std::max(largest, std::abs(tight.values()[i] - free.values()[i]));
    CHECK(largest <= rounding * *std::ranges::max_element(free.values()));
}

TEST_CASE("a budget that is never spent changes no byte", "[budget]") {
    const Scene scene = room_with_moving_block();
    DdgiOptions options = with_budget(1'000'000);
    options.updates = 1;
    const Image ample = render(scene, 4, options).image;
    options.budget = std::nullopt;
    CHECK(same_bytes(ample, render(scene, 4, options).image));
}

TEST_CASE("with a budget the picture is the same bytes at any number of threads", "[budget]") {
    DdgiOptions options = with_budget(100);
    options.updates = 1;
    const auto on = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return render(room_with_moving_block(), 5, options);
    };
    const DdgiResult one = on(1);
    CHECK(one.figures.surfels_waiting > 0);
    CHECK(same_bytes(one.image, on(2).image));
    CHECK(same_bytes(one.image, on(3).image));
}

TEST_CASE("a still has converged when no surfel waits any more", "[budget]") {
    const Scene scene = room_with_moving_block();
    const DdgiResult tight = render(scene, 6, with_budget(60));
    CHECK(tight.figures.converged);
    CHECK(tight.figures.surfels_waiting == 0);
    const DdgiResult free = render(scene, 6, {});
    CHECK(tight.figures.updates > free.figures.updates);
    CHECK(mean(tight.image, "indirect") == Approx(mean(free.image, "indirect")).epsilon(1e-3));
}

TEST_CASE("budgets that cannot be kept are refused", "[budget]") {
    const Scene scene = room_with_moving_block();
    CHECK_THROWS_AS(render(scene, 0, with_budget(0)), UsageError);
    DdgiOptions options = with_budget(10);
    options.cache = false;
    CHECK_THROWS_WITH(render(scene, 0, options), Catch::Contains("--no-cache"));
    options = with_budget(10);
    options.model = "irradiance";
    options.set["turnedRays"] = 1.;
    CHECK_THROWS_WITH(render(scene, 0, options), Catch::Contains("turn"));
}
