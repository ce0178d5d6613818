// SPDX-License-Identifier: Apache-2.0
#include "reports/scene_report.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>

#include "ddgi/model.h"
#include "ddgi/thesis_model.h"
#include "reports/layer_statistics.h"
#include "reports/scene_hash.h"
#include "reports/stages.h"
#include "reports/words.h"
#include "scenes/errors.h"
#include "scenes/scene_files.h"

namespace plumbline::reports {

namespace {

/// What a probe model and a fit take, in samples a pixel of the path tracer, for the time left.
constexpr double work_of_model = 30;
constexpr double work_of_fit = 30;
constexpr double work_of_animation_step = 20;
constexpr double work_of_frontier = 200;
constexpr double work_of_audit = 10;

constexpr int audited_bounces = 4;
constexpr int audited_points = 3000;

/// Three seeds, for pictures of one seed share their samples, and so their noise.
constexpr std::uint64_t truth_seed = 0;
constexpr std::uint64_t picture_seed = 1;
constexpr std::uint64_t half_seed = 2;

pathtracer::RenderResult trace(const Scene& scene, int frame, int spp, std::uint64_t seed) {
    pathtracer::RenderOptions options;
    options.spp = spp;
    options.seed = seed;
    return pathtracer::render(scene, frame, options);
}

LayerError layer_error(const Image& reference, const Image& test, const std::string& layer,
                       const Image* half) {
    compare::ComparisonOptions options;
    options.halves.test = half;
    return {layer_mean(reference, layer), layer_mean(test, layer),
            compare::compare_images(reference, test, layer, options)};
}

/// `half`: the test once more with independent noise, if it has any, which tells that noise from
/// bias without trusting variances of few samples.
PictureErrors picture_errors(const Image& reference, const Image& test,
                             const Image* half = nullptr) {
    return {layer_error(reference, test, "", half), layer_error(reference, test, "indirect", half)};
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

/// The models in motion, the frontier, and where the energy goes.
void measure_studies(SceneReport& report, const Scene& scene, const Quality& quality,
                     Stages& stages) {
    if (moving_frames(scene)) {
        stages.begin(report.name + ": the animation",
                     quality.animation.steps * work_of_animation_step);
        std::vector<TitledOptions> models;
        for (const ModelRun& run : report.models) models.emplace_back(run.title, run.options);
        report.animation = measure_animation(scene, models, quality.animation);
    } else {
        report.left_out.emplace_back("the error over the animation: nothing moves");
    }
    stages.begin(report.name + ": what accuracy costs in time", work_of_frontier);
    report.frontier = measure_quick_frontier(scene, report.frame);
    stages.begin(report.name + ": where the energy goes", work_of_audit);
    for (const ModelRun& run : report.models)
        if (run.options.set.empty())
            report.audits.push_back(compare::energy_audit(scene, report.frame, run.options,
                                                          audited_bounces, audited_points));
}

/// Why a report of the scene does without the thesis's model; none if it has it.
std::optional<std::string> reason_without_thesis(const Scene& scene) {
    if (!scene.thesis)
        return "the scene gives no constants for it (key \"thesis\" of the scene file)";
    return ddgi::thesis_obstacle(probe_grid(scene));
}

}  // namespace

Quality quality_of(bool quick) {
    if (quick) return {"quick", 64, {1, 4, 16}, {6, 128. * 72., 32}, 240. * 135., 32};
    return {"default", 512, {1, 4, 16, 64}, {15, 160. * 90., 64}, 320. * 180., 128};
}

double total_work(const Scene& scene, const Quality& quality) {
    const bool thesis = !reason_without_thesis(scene);
    const auto models = static_cast<double>(other_models().size() + (thesis ? 2 : 0));
    double work = quality.truth_spp + models * work_of_model + (thesis ? work_of_fit : 0);
    for (const int spp : quality.path_tracer_spp) work += 2 * spp;
    if (moving_frames(scene)) work += quality.animation.steps * work_of_animation_step;
    return work + work_of_frontier + work_of_audit;
}

SceneReport measure(const std::string& argument, const Scene& scene, int frame,
                    const Quality& quality, Stages& stages) {
    std::vector<pathtracer::RenderResult> quick_pictures, halves;
    for (const int spp : quality.path_tracer_spp) {
        stages.begin(fmt::format("{}: path tracer at {} spp", scene.name, spp), 2 * spp);
        quick_pictures.push_back(trace(scene, frame, spp, picture_seed));
        halves.push_back(trace(scene, frame, spp, half_seed));
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
    for (std::size_t i = 0; i < quick_pictures.size(); ++i) {
        const pathtracer::RenderResult& picture = quick_pictures[i];
        report.path_tracer.push_back(
            {picture.spp, picture.seconds, picture.rays,
             picture_errors(report.truth.image, picture.image, &halves[i].image)});
    }
    if (const auto reason = reason_without_thesis(scene))
        report.left_out.push_back("model thesis: " + *reason);
    else
        measure_thesis(report, scene, stages);
    for (const std::string& model : other_models()) {
        stages.begin(fmt::format("{}: {}", scene.name, model), work_of_model);
        ddgi::DdgiOptions options;
        options.model = model;
        report.models.push_back(run_model(report, scene, model, model, options));
    }
    measure_studies(report, scene, quality, stages);
    return report;
}

}  // namespace plumbline::reports
