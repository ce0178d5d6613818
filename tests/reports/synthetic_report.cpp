// SPDX-License-Identifier: Apache-2.0
#include "tests/reports/synthetic_report.h"

#include <cmath>
#include <random>

#include "reports/layer_statistics.h"

namespace plumbline::reports {

const char* const hostile_text =
    "</script><script>alert(1)</script><img src=x onerror=alert(2)> \"'&{{version}} <!--";

namespace {

constexpr float standard_error = 0.01f;

/// Smooth and in full colour: no two pixels are alike.
float picture_value(float x, float y, std::size_t c) {
    const float wave = 0.5f + 0.5f * std::sin(9.f * x + 5.f * y + 2.f * static_cast<float>(c));
    return 0.05f + 0.6f * wave * x + 0.3f * y;
}

/// Indirect light of `gain` times the truth's, and noise of `sigma`; radiance has .4 more.
Image picture(int width, int height, float gain, float sigma, unsigned seed) {
    Image image(width, height);
    std::mt19937 random(seed);
    std::normal_distribution<float> noise;
    const auto radiance = image.layer("");
    const auto indirect = image.layer("indirect");
    const auto bounce1 = image.layer("bounce1");
    const auto variance = image.layer("variance");
    const auto variance_indirect = image.layer("variance_indirect");
    for (std::size_t i = 0; i < image.pixels(); ++i) {
        const auto column = static_cast<float>(i % static_cast<std::size_t>(width));
        const auto row = static_cast<float>(i / static_cast<std::size_t>(width));
        for (std::size_t c = 0; c < 3; ++c) {
            const float value = gain * picture_value(column / static_cast<float>(width),
                                                     row / static_cast<float>(height), c) +
                                sigma * noise(random);
            indirect[c][i] = value;
            bounce1[c][i] = 0.5f * value;
            radiance[c][i] = value + 0.4f;
            variance[c][i] = variance_indirect[c][i] = sigma * sigma;
        }
    }
    return image;
}

PictureErrors errors_of(const Image& truth, const Image& test) {
    const auto error = [&](const char* layer) -> LayerError {
        return {layer_mean(truth, layer), layer_mean(test, layer),
                compare::compare_images(truth, test, layer)};
    };
    return {error(""), error("indirect")};
}

ModelRun model(const Image& truth, const std::string& id, float gain, double seconds) {
    Image image = picture(truth.width(), truth.height(), gain, 0.f, 0);
    ddgi::DdgiOptions options;
    options.model = id.substr(0, id.find('-'));
    ddgi::FrameFigures figures;
    figures.place_ms = 4;
    figures.light_ms = 60;
    figures.primary_ms = 300;
    figures.updates = 30;
    figures.probes = 9261;
    figures.surfels = 592704;
    figures.converged = true;
    const PictureErrors errors = errors_of(truth, image);
    ddgi::DdgiResult result{std::move(image), figures, seconds, {{"probeBrightness", 26.2}}, {}};
    return {id,
            id,
            "plumbline ddgi --model " + options.model + " -o " + id + ".exr",
            options,
            std::move(result),
            306,
            errors};
}

compare::FitResult fit_result() {
    return {.model = "thesis",
            .scenes = {"synthetic"},
            .constants = {{"probeBrightness", 285.2, 1.31, false},
                          {"falloffRegulator", 701.5, 0.42, true}},
            .rmse_before = 0.379,
            .rmse_after = 0.201,
            .reduced_chi_square = 812.3,
            .gain = 10.9,
            .gain_standard_error = 0.02,
            .rmse_gain = 0.243,
            .notes = {"probeBrightness and bounceAttenuation act only as a product."},
            .combinations = {{"probeBrightness * bounceAttenuation", 5.98, 0.087}},
            .transfer = {}};
}

SceneReport scene_report(int width, int height, const std::string& text) {
    Image truth = picture(width, height, 1.f, standard_error, 1);
    SceneReport scene{.argument = text,
                      .name = text,
                      .description = "About " + text,
                      .hash = "0123456789abcdef0123456789abcdef01234567",
                      .frame = 350,
                      .truth_command = "plumbline render -o truth.exr",
                      .truth = {truth, 512, 95.5, 1'234'567'890, 1e-4, {}, {}},
                      .models = {},
                      .path_tracer = {},
                      .fit = FitRun{fit_result(), 8.5},
                      .effects = {{"point lights", true, "one light"}, {"fog", false, text}},
                      .left_out = {"left out: " + text}};
    scene.models.push_back(model(truth, "thesis", 0.08f, 1.2));
    scene.models.push_back(model(truth, "thesis-fitted", 0.7f, 1.3));
    scene.models.push_back(model(truth, "conserving", 0.97f, 3.4));
    for (const int spp : {1, 4, 16, 64}) {
        const float sigma = standard_error * std::sqrt(512.f / static_cast<float>(spp));
        const Image image = picture(width, height, 1.f, sigma, static_cast<unsigned>(spp) + 7);
        scene.path_tracer.push_back(
            {spp, 0.19 * spp, 2'400'000u * static_cast<unsigned>(spp), errors_of(truth, image)});
    }
    scene.animation =
        AnimationErrors{200,
                        350,
                        width,
                        height,
                        64,
                        10,
                        {200, 275, 350},
                        {.2, .2, .2},
                        {{"thesis", {{.08, .38, .14}, {.08, .39, .15}, {.09, .4, .16}}},
                         {text, {{1, .02, 1e-4}, {.98, .04, 1e-3}, {1, .02, -1e-6}}}}};
    scene.audits = {{text, "conserving", 350, 10, 0, 5, 0, {{1, 4, 1, 3, 3.03, .03, .01}}}};
    return scene;
}

}  // namespace

Report synthetic_report(int width, int height, int scenes, bool hostile) {
    Report report{.version = "1.2.3",
                  .date = "2026-01-02 03:04 UTC",
                  .command = "plumbline report synthetic -o out",
                  .quality = "default",
                  .machine = {"Example CPU", "Linux", 2},
                  .scenes = {}};
    for (int i = 0; i < scenes; ++i)
        report.scenes.push_back(
            scene_report(width, height, hostile ? hostile_text : "synthetic-" + std::to_string(i)));
    const std::string& first = report.scenes.front().name;
    report.transfer = Transfer{width,
                               height,
                               64,
                               {{first, 350, first, 350, .1},
                                {first, 350, "courtyard", 0, .9},
                                {"courtyard", 0, first, 350, .3},
                                {"courtyard", 0, "courtyard", 0, .2}}};
    return report;
}

}  // namespace plumbline::reports
