// SPDX-License-Identifier: Apache-2.0
#include "reports/scene_report.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>

#include "ddgi/model.h"
#include "reports/layer_statistics.h"
#include "reports/scene_hash.h"
#include "reports/stages.h"
#include "reports/words.h"
#include "scenes/errors.h"
#include "scenes/scene_files.h"

namespace plumbline::reports {

namespace {

/// What a probe model and a fit take, in samples a pixel of the path tracer, for the time left.
constexpr double work_of_model = 20;
constexpr double work_of_fit = 60;

/// Two seeds, for pictures of one seed share their samples, and so their noise.
constexpr std::uint64_t truth_seed = 0;
constexpr std::uint64_t other_seed = 1;

pathtracer::RenderResult trace(const Scene& scene, int frame, int spp, std::uint64_t seed) {
    pathtracer::RenderOptions options;
    options.spp = spp;
    options.seed = seed;
    return pathtracer::render(scene, frame, options);
}

LayerError layer_error(const Image& reference, const Image& test, const std::string& layer) {
    return {layer_mean(reference, layer), layer_mean(test, layer),
            compare::compare_images(reference, test, layer)};
}

PictureErrors picture_errors(const Image& reference, const Image& test) {
    return {layer_error(reference, test, ""), layer_error(reference, test, "indirect")};
}

/// Of a picture with noise of its own: without its variances the split would call that noise bias.
PictureErrors noisy_picture_errors(const Image& reference, const Image& test) {
    PictureErrors errors = picture_errors(reference, test);
    for (LayerError* error : {&errors.radiance, &errors.indirect})
        if (error->comparison.noise && !error->comparison.noise->test_variance)
            error->comparison.noise.reset();
    return errors;
}

/// The words that every command of this scene begins with.
std::string command_words(const std::string& subcommand, const SceneReport& report,
                          const Scene& scene) {
    return fmt::format("plumbline {} {} --frame {} --size {}x{}", subcommand,
                       shell_word(report.argument), report.frame, scene.camera.width,
                       scene.camera.height);
}

/// Placing at frame 0 is starting up; later it is what the frame's motion asks for.
double frame_ms(const ddgi::FrameFigures& figures, int frame) {
    return figures.bvh_ms + (frame > 0 ? figures.place_ms : 0) + figures.light_ms +
           figures.primary_ms;
}

ModelRun run_model(const SceneReport& report, const Scene& scene, const std::string& id,
                   const std::string& title, const ddgi::DdgiOptions& options) {
    std::string command =
        command_words("ddgi", report, scene) + " --model " + shell_word(options.model);
    for (const auto& [name, value] : options.set)
        command += fmt::format(" --set {}", shell_word(fmt::format("{}={}", name, value)));
    command += fmt::format(" -o {}.exr", id);
    ddgi::DdgiOptions in_motion = options;
    in_motion.updates = 1;
    const double motion_ms =
        frame_ms(ddgi::render(scene, report.frame, in_motion).figures, report.frame);
    ddgi::DdgiResult result = ddgi::render(scene, report.frame, options);
    PictureErrors errors = picture_errors(report.truth.image, result.image);
    return {id, title, command, options, std::move(result), motion_ms, std::move(errors)};
}

FitRun run_fit(const SceneReport& report, const Scene& scene) {
    const auto start = std::chrono::steady_clock::now();
    compare::FitResult result = compare::fit({{&scene, report.frame, &report.truth.image}});
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    return {std::move(result), elapsed.count()};
}

/// The thesis's model with its published constants, and with those that fit best.
void measure_thesis(SceneReport& report, const Scene& scene, Stages& stages) {
    const std::string& name = report.name;
    ddgi::DdgiOptions options;
    options.model = "thesis";
    stages.begin(name + ": thesis", work_of_model);
    report.models.push_back(run_model(report, scene, "thesis", "thesis, as published", options));
    stages.begin(name + ": fit of the thesis's constants", work_of_fit);
    try {
        report.fit = run_fit(report, scene);
    } catch (const FitError& error) {
        report.left_out.push_back(fmt::format("thesis, fitted: {}", error.what()));
        return;
    }
    for (const compare::FittedConstant& constant : report.fit->result.constants)
        options.set[constant.name] = constant.value;
    stages.begin(name + ": thesis with fitted constants", work_of_model);
    report.models.push_back(run_model(report, scene, "thesis-fitted", "thesis, fitted", options));
}

/// Everything that ddgi offers beside the thesis's model, best first.
std::vector<std::string> other_models() {
    std::vector<std::string> names = ddgi::model_names();
    std::erase(names, "thesis");
    return names;
}

}  // namespace

Quality quality_of(bool quick) {
    if (quick) return {"quick", 64, {1, 4, 16}};
    return {"default", 512, {1, 4, 16, 64}};
}

double total_work(const Scene& scene, const Quality& quality) {
    const auto models = static_cast<double>(other_models().size() + (scene.thesis ? 2 : 0));
    double work = quality.truth_spp + models * work_of_model + (scene.thesis ? work_of_fit : 0);
    for (const int spp : quality.path_tracer_spp) work += spp;
    return work;
}

SceneReport measure(const std::string& argument, const Scene& scene, int frame,
                    const Quality& quality, Stages& stages) {
    std::vector<pathtracer::RenderResult> quick_pictures;
    for (const int spp : quality.path_tracer_spp) {
        stages.begin(fmt::format("{}: path tracer at {} spp", scene.name, spp), spp);
        quick_pictures.push_back(trace(scene, frame, spp, other_seed));
    }
    stages.begin(fmt::format("{}: truth at {} spp", scene.name, quality.truth_spp),
                 quality.truth_spp);
    SceneReport report{.argument = argument,
                       .name = scene.name,
                       .description = scene.description,
                       .hash = scene_hash(load_scene(argument)),
                       .frame = frame,
                       .truth_command = {},
                       .truth = trace(scene, frame, quality.truth_spp, truth_seed),
                       .models = {},
                       .path_tracer = {},
                       .fit = {},
                       .effects = effect_reasons(scene),
                       .left_out = scene.not_simulated};
    report.truth_command = command_words("render", report, scene) +
                           fmt::format(" --spp {} -o truth.exr", quality.truth_spp);
    for (const pathtracer::RenderResult& picture : quick_pictures)
        report.path_tracer.push_back({picture.spp, picture.seconds, picture.rays,
                                      noisy_picture_errors(report.truth.image, picture.image)});
    if (scene.thesis)
        measure_thesis(report, scene, stages);
    else
        report.left_out.push_back(
            "model thesis: the scene gives no constants for it (key \"thesis\" of the scene file)");
    for (const std::string& model : other_models()) {
        stages.begin(fmt::format("{}: {}", scene.name, model), work_of_model);
        ddgi::DdgiOptions options;
        options.model = model;
        report.models.push_back(run_model(report, scene, model, model, options));
    }
    return report;
}

}  // namespace plumbline::reports
