// SPDX-License-Identifier: Apache-2.0
#include "reports/sequence.h"

#include <sys/wait.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <sstream>

#include "reports/published_timings.h"
#include "reports/sequence_summary.h"
#include "scenes/errors.h"
#include "scenes/scene_files.h"
#include "tests/ddgi/small_scenes.h"
#include "tests/scenes/temporary_folder.h"

using namespace plumbline;
using namespace plumbline::reports;
namespace fs = std::filesystem;

namespace {

Scene small_room() {
    Scene scene = ddgi::room_with_moving_block();
    scene.camera.width = 8;
    scene.camera.height = 6;
    return scene;
}

/// The mean of a CSV column over the rows whose `moved` is `moved`, the first `skip` left out:
/// a second formulation of the summary.
double column_mean(const std::string& csv, const std::string& column, char moved, int skip) {
    std::istringstream lines(csv);
    std::string line;
    std::getline(lines, line);
    const auto cells = [](const std::string& text) {
        std::vector<std::string> list;
        std::istringstream stream(text);
        for (std::string cell; std::getline(stream, cell, ',');) list.push_back(cell);
        return list;
    };
    const std::vector<std::string> head = cells(line);
    const auto place = [&](const std::string& name) {
        return static_cast<std::size_t>(std::find(head.begin(), head.end(), name) - head.begin());
    };
    double sum = 0;
    int rows = 0;
    for (int row = 0; std::getline(lines, line); ++row) {
        const std::vector<std::string> values = cells(line);
        if (row < skip || values.at(place("moved"))[0] != moved) continue;
        sum += std::stod(values.at(place(column)));
        ++rows;
    }
    return sum / rows;
}

int exit_of(const std::string& arguments) {
    const std::string command = std::string(PLUMBLINE_BINARY) + " sequence " + arguments;
    return WEXITSTATUS(std::system((command + " >/dev/null 2>&1").c_str()));
}

}  // namespace

TEST_CASE("the published timings give the savings that the thesis states", "[reports][sequence]") {
    CHECK(published_timings().size() == 12);
    CHECK(published_saving_percent("cornell-box").value() == Approx(85.7).margin(.05));
    CHECK(published_saving_percent("room-with-door").value() == Approx(84.8).margin(.05));
    CHECK_FALSE(published_saving_percent("furnace").has_value());
    const PublishedTiming* room = published_timing("room-with-door", "gi_off", 0);
    REQUIRE(room != nullptr);
    CHECK(room->probes == 5292);
    CHECK(room->primary_animated_ms == 3.0399);
}

TEST_CASE("a sequence counts what each configuration re-places and when", "[reports][sequence]") {
    const Sequence sequence = measure_sequence(small_room(), {"thesis", 10, 2});
    // The block of this scene moves from frame 2 to frame 6.
    CHECK(sequence.moved == std::vector<bool>{0, 0, 0, 1, 1, 1, 1, 0, 0, 0});
    REQUIRE(sequence.runs.size() == 6);
    CHECK(frames_left_out(sequence) == 2);
    for (const SequenceRun& run : sequence.runs) {
        const bool off = run.configuration.name == "gi_off";
        const std::uint64_t all = run.frames[0].replaced;
        CHECK((all == 0) == off);
        CHECK(run.frames[1].primary_ms > 0);
        for (std::size_t i = 1; i < run.frames.size(); ++i) {
            CAPTURE(run.configuration.title, i);
            if (run.configuration.name == "no_surfels") CHECK(run.frames[i].replaced == all);
            if (run.configuration.name == "full_gi")
                CHECK((run.frames[i].replaced > 0) == sequence.moved[i]);
            if (off) CHECK(run.frames[i].probe_update_ms() == 0);
        }
    }
}

TEST_CASE("means of a sequence are those of its CSV files", "[reports][sequence]") {
    const Sequence sequence = measure_sequence(small_room(), {"conserving", 10, 1});
    for (const SequenceRun& run : sequence.runs) {
        const std::string csv = sequence_csv(sequence, run);
        const auto still = sequence_means(sequence, run, false);
        const auto animated = sequence_means(sequence, run, true);
        REQUIRE((still && animated));
        CHECK(still->frames + animated->frames == 8);
        CHECK(still->primary_ms == Approx(column_mean(csv, "primary_ms", '0', 2)).margin(1e-5));
        CHECK(animated->probe_update_ms ==
              Approx(column_mean(csv, "probe_update_ms", '1', 2)).margin(1e-5));
        CHECK(animated->replaced == Approx(column_mean(csv, "replaced", '1', 2)));
    }
    const nlohmann::ordered_json summary = summary_json(sequence, "cornell-box");
    CHECK(summary["configurations"][1]["per_probe"] == 64);
    CHECK(summary["published"]["configurations"].size() == 6);
    const double with = summary["configurations"][1]["probe_update_animated_ms"];
    const double without = summary["configurations"][0]["probe_update_animated_ms"];
    CHECK(summary["saving_animated_percent"] == Approx(100 * (1 - with / without)));
}

TEST_CASE("a scene in which nothing moves has no animated mean", "[reports][sequence]") {
    Scene scene = small_room();
    scene.frames = 1;
    const Sequence sequence = measure_sequence(scene, {"thesis", 10, 1});
    CHECK_FALSE(sequence_means(sequence, sequence.runs[0], true).has_value());
    CHECK(summary_json(sequence, scene.name)["saving_animated_percent"].is_null());
    CHECK_THROWS_AS(measure_sequence(scene, {"thesis", 9, 1}), UsageError);
    CHECK_THROWS_AS(measure_sequence(scene, {"thesis", 10, 0}), UsageError);
}

TEST_CASE("sequence writes its page and figures whole or not at all", "[reports][sequence]") {
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "room.json";
    Scene coarse = load_scene("cornell-box");
    coarse.probes = ProbeGrid{{-200, 0, -200}, 80, {6, 6, 6}};
    save_scene(coarse, file);
    const fs::path out = folder.path() / "out";
    REQUIRE(exit_of(file.string() + " --frames 10 --size 8x6 -o " + out.string()) == 0);
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(out)) names.insert(entry.path().filename());
    CHECK(names == std::set<std::string>{"index.html", "summary.json", "no_surfels.csv",
                                         "gi_off.csv", "full_gi_64.csv", "full_gi_96.csv",
                                         "full_gi_128.csv", "full_gi_160.csv"});
    const fs::path other = folder.path() / "other";
    CHECK(exit_of(file.string() + " --frames 9 -o " + other.string()) == 2);
    CHECK(exit_of(file.string() + " --model theses --frames 10 -o " + other.string()) == 2);
    CHECK(exit_of(file.string() + " --frames 10 -o " + file.string()) == 2);
    CHECK_FALSE(fs::exists(other));
}
