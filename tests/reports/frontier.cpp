// SPDX-License-Identifier: Apache-2.0
#include "reports/frontier.h"

#include <sys/wait.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>

#include "pathtracer/render.h"
#include "reports/frontier_page.h"
#include "reports/frontier_sentences.h"
#include "scenes/errors.h"
#include "scenes/scene_files.h"
#include "tests/ddgi/small_scenes.h"
#include "tests/reports/page_parts.h"
#include "tests/scenes/temporary_folder.h"

using namespace plumbline;
using namespace plumbline::reports;
namespace fs = std::filesystem;

namespace {

FrontierPoint made_up_point(const std::string& method, const std::string& setting, double seconds,
                            double error) {
    FrontierPoint point;
    point.method = method;
    point.setting = setting;
    point.seconds = {seconds, seconds, seconds};
    point.frame_seconds = Spread{seconds / 10, seconds / 10, seconds / 10};
    if (error > 0) point.error = Spread{error, error, error};
    return point;
}

/// Error 1 / sqrt(t) of the path tracer against a model with two settings.
Frontier made_up() {
    Frontier frontier{"made up", 0, 16, 9, 3, .01, {}};
    for (const double seconds : {1., 4., 16.}) {
        frontier.points.push_back(
            made_up_point(path_tracer_method, "", seconds, 1 / std::sqrt(seconds)));
        frontier.points.back().frame_seconds = frontier.points.back().seconds;
    }
    frontier.points.push_back(made_up_point("probes", "rough", 2, .105));
    frontier.points.push_back(made_up_point("probes", "fine", 8, .1));
    frontier.points.push_back(made_up_point("probes", "finest", 16, 0));
    return frontier;
}

bool has(const std::vector<std::string>& sentences, const std::string& words) {
    for (const std::string& sentence : sentences)
        if (sentence.find(words) != std::string::npos) return true;
    return false;
}

/// The closed room as a small picture, path-traced.
struct SmallRoom {
    Scene scene = ddgi::room_with_moving_block();
    Image truth{1, 1};
    SmallRoom() {
        scene.camera.width = 24;
        scene.camera.height = 18;
        pathtracer::RenderOptions render;
        render.spp = 1024;
        truth = pathtracer::render(scene, 4, render).image;
    }
};

int exit_of(const std::string& arguments) {
    const std::string command = std::string(PLUMBLINE_BINARY) + " frontier " + arguments;
    return WEXITSTATUS(std::system((command + " >/dev/null 2>&1").c_str()));
}

}  // namespace

TEST_CASE("the frontier's sentences tell what made-up points hold", "[reports][frontier]") {
    const std::vector<std::string> sentences = frontier_sentences(made_up());
    for (const std::string& sentence : sentences) UNSCOPED_INFO(sentence);
    CHECK(has(sentences, "to the power -0.500"));
    CHECK(has(sentences, "a tenth less error takes 23 % more time"));
    CHECK(has(sentences, "half the error 4.00 times"));
    CHECK(has(sentences, "no setting measured leaves less than RMSE 0.100 (fine), 8.00 s"));
    CHECK(has(sentences, "1 min 40 s, extrapolated: 12.5 times the time of the still"));
    CHECK(has(sentences, "125 times that of the frame"));
    CHECK(has(sentences, "the last tenth costs 4.00 times the time"));
    CHECK(has(sentences, "path tracer from 1.00 s to 2.00 s (RMSE 1.00 to 0.707), then probes"));
    CHECK(has(sentences, "1 of 6 pictures"));
}

TEST_CASE("a spread is the median between least and most", "[reports][frontier]") {
    const Spread odd = spread_of({3, 1, 2});
    CHECK((odd.median == 2 && odd.least == 1 && odd.most == 3));
    CHECK(spread_of({4, 1}).median == 2.5);
}

TEST_CASE("the frontier's page and figures hold every picture", "[reports][frontier]") {
    const Frontier frontier = made_up();
    CHECK(count(frontier_csv(frontier), "\n") == frontier.points.size() + 1);
    const nlohmann::ordered_json json = frontier_json(frontier);
    CHECK(json["points"].size() == 6);
    CHECK(json["points"][5]["error"].is_null());
    CHECK(json["still"]["floors"][1]["path_tracer_seconds"] == Approx(100));
    CHECK(json["still"]["pareto"].size() == 3);
    const std::string html = study_html(frontier_page(frontier, "plumbline frontier"));
    CHECK(page_json(html)["charts"].size() == 2);
    CHECK(html.find("{{") == std::string::npos);
    Frontier hidden = frontier;
    for (FrontierPoint& point : hidden.points) point.error.reset();
    CHECK(has(frontier_sentences(hidden), "did not fall"));
    CHECK(page_json(study_html(frontier_page(hidden, "")))["charts"].empty());
}

TEST_CASE("a frontier tells the path tracer's noise from the probes' bias", "[reports][frontier]") {
    const SmallRoom room;
    FrontierOptions options{{1, 16}, {}, 4};
    options.cases.push_back({"conserving", "64 surfels", "--model conserving", {}});
    const Frontier frontier = measure_frontier(room.scene, 4, room.truth, options);
    const double truth_square = frontier.truth_noise * frontier.truth_noise;
    REQUIRE(frontier.points.size() >= 4);
    for (const FrontierPoint& point : frontier.points) {
        CAPTURE(point.method, point.setting);
        CHECK(point.non_finite == 0);
        CHECK(point.seconds.least <= point.seconds.median);
        const bool traced = point.method == path_tracer_method;
        CHECK((point.bytes > 0) != traced);
        CHECK((point.noise_mse > 0) == traced);
        if (!traced) CHECK(point.mse == Approx(point.bias_mse + truth_square));
        if (!traced) continue;
        // Unbiased: all of its error is noise, within four standard errors of the interval's.
        const double sigma = (point.bias_mse_ci95[1] - point.bias_mse_ci95[0]) / (2 * 1.96);
        CHECK(std::abs(point.bias_mse) < 4 * sigma);
        CHECK(point.error->median == Approx(std::sqrt(point.noise_mse)).epsilon(.3));
    }
    CHECK(frontier.points[1].noise_mse < frontier.points[0].noise_mse / 8);
    const FrontierPoint& settled = frontier.points.back();
    CHECK(settled.frame_seconds.has_value());
    CHECK_FALSE(frontier.points[2].frame_seconds.has_value());
    CHECK(frontier.points[2].updates == 1);
    CHECK(settled.bias_mse < frontier.points[2].bias_mse);
    options.repeats = 1;
    CHECK_THROWS_AS(measure_frontier(room.scene, 4, room.truth, options), UsageError);
}

TEST_CASE("the frontier's cases have options of their own", "[reports][frontier]") {
    const Scene scene = load_scene("cornell-box");
    std::set<std::string> options, methods;
    for (const FrontierCase& one : frontier_cases(scene, false)) {
        CHECK(options.insert(one.options).second);
        methods.insert(one.method);
    }
    CHECK(methods ==
          std::set<std::string>{"thesis", "irradiance", "conserving", "conserving, octants"});
    CHECK(frontier_cases(scene, true).size() < options.size());
}

TEST_CASE("frontier writes its files whole or not at all", "[reports][frontier]") {
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "room.json";
    Scene coarse = load_scene("cornell-box");
    coarse.probes = ProbeGrid{{-200, 0, -200}, 80, {6, 6, 6}};
    save_scene(coarse, file);
    const fs::path out = folder.path() / "out";
    REQUIRE(exit_of(file.string() + " --quick --size 16x12 -o " + out.string()) == 0);
    for (const char* name : {"index.html", "frontier.csv", "frontier.json"})
        CHECK(fs::exists(out / name));
    const fs::path other = folder.path() / "other";
    CHECK(exit_of(file.string() + " --repeats 1 -o " + other.string()) == 2);
    CHECK(exit_of(file.string() + " --reference none.exr -o " + other.string()) == 2);
    CHECK(exit_of(file.string() + " --frame 999 -o " + other.string()) == 2);
    CHECK_FALSE(fs::exists(other));
}
