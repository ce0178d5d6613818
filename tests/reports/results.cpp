// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>

#include "reports/equal_error.h"
#include "reports/results_json.h"
#include "reports/verdict.h"
#include "tests/reports/synthetic_report.h"

using namespace plumbline;
using namespace plumbline::reports;

namespace {

void check_keys(const nlohmann::ordered_json& json, const std::vector<std::string>& keys) {
    for (const std::string& key : keys) {
        CAPTURE(key);
        CHECK(json.contains(key));
    }
    CHECK(json.size() == keys.size());
}

}  // namespace

TEST_CASE("results.json has every key that its header promises", "[reports][json]") {
    const nlohmann::ordered_json json = results_json(synthetic_report(32, 18, 2));
    check_keys(json, {"version", "date", "command", "quality", "machine", "scenes", "transfer",
                      "shared_fit", "hard_cases"});
    REQUIRE(json["scenes"].size() == 2);
    const nlohmann::ordered_json& scene = json["scenes"][1];
    check_keys(scene, {"scene", "description", "hash", "frame", "width", "height", "truth",
                       "models", "path_tracer", "path_tracer_line", "fit", "effects", "left_out",
                       "animation", "frontier", "audit", "verdict"});
    check_keys(scene["animation"],
               {"first", "last", "width", "height", "truth_spp", "updates", "models"});
    CHECK(scene["animation"]["models"][0]["errors"][1]["frame"] == 275);
    CHECK(json["transfer"].size() == 4);
    check_keys(scene["truth"],
               {"command", "spp", "seconds", "rays", "relmse_estimate", "mean", "noise_rmse"});
    REQUIRE(scene["models"].size() == 3);
    const nlohmann::ordered_json& model = scene["models"][2];
    check_keys(model, {"id", "title", "model", "command", "surfels", "set", "seconds", "frame_ms",
                       "notes", "figures", "errors"});
    const nlohmann::ordered_json& error = model["errors"]["indirect"];
    for (const char* key : {"metrics", "noise", "non_finite", "pixels", "reference_mean",
                            "test_mean", "mean_ratio"}) {
        CAPTURE(key);
        CHECK(error.contains(key));
    }
    CHECK(error["mean_ratio"].get<double>() == Approx(0.97).margin(0.01));
    CHECK(json["scenes"][0]["truth"]["noise_rmse"]["indirect"].get<double>() == Approx(0.01));
}

TEST_CASE("constants without a standard error are null in results.json", "[reports][json]") {
    Report report = synthetic_report(32, 18);
    report.scenes[0].fit->result.constants[0].standard_error = HUGE_VAL;
    const std::string text = results_json(report).dump();
    const nlohmann::json back = nlohmann::json::parse(text);
    CHECK(back["scenes"][0]["fit"]["constants"][0]["standard_error"].is_null());
}

TEST_CASE("the path tracer's line has the slope of independent samples and meets its points",
          "[reports]") {
    const Report report = synthetic_report(96, 54);
    const SceneReport& scene = report.scenes[0];
    const std::optional<PathTracerLine> line = path_tracer_line(scene);
    REQUIRE(line);
    CHECK(line->slope == Approx(-0.5).margin(0.02));
    // 16 samples a pixel were made with noise of .01 sqrt(512 / 16), in .19 s a sample.
    CHECK(line->seconds_to(0.01 * std::sqrt(32.)) == Approx(16 * 0.19).epsilon(0.05));
    CHECK(line->extrapolates(100));
    CHECK(!line->extrapolates(1));
}

TEST_CASE("the truth's own noise is taken off an error in quadrature", "[reports]") {
    const Report report = synthetic_report(96, 54);
    const SceneReport& scene = report.scenes[0];
    const LayerError& conserving = scene.models[2].errors.indirect;
    // The model is .97 of a truth without noise: its error is .03 of that truth's RMS.
    const Image& image = scene.models[2].result.image;
    double squares = 0;
    for (const std::span<const float> channel : image.layer("indirect"))
        for (const float value : channel) squares += double{value} * double{value};
    const double rms = std::sqrt(squares / (3. * static_cast<double>(image.pixels()))) / 0.97;
    CHECK(*error_without_truth_noise(scene, conserving) == Approx(0.03 * rms).epsilon(0.05));
}

TEST_CASE("the verdict names the model with the least error, how far off it is, and its time",
          "[reports][verdict]") {
    const Report report = synthetic_report(96, 54);
    const Verdict verdict = verdict_of(report.scenes[0]);
    REQUIRE(verdict.best != nullptr);
    CHECK(verdict.best->id == "conserving");
    CHECK_THAT(verdict.headline, Catch::Contains("conserving") && Catch::Contains("too dark") &&
                                     Catch::Contains("306 ms") && Catch::Contains("3.40 s"));
    CHECK_THAT(verdict.sentences[0],
               Catch::Contains("12.5 times too dark") && Catch::Contains("1.20 s"));
}

TEST_CASE("a scene without models has a verdict that says so", "[reports][verdict]") {
    Report report = synthetic_report(32, 18);
    report.scenes[0].models.clear();
    const Verdict verdict = verdict_of(report.scenes[0]);
    CHECK(verdict.best == nullptr);
    CHECK(verdict.headline == "No model was run.");
}
