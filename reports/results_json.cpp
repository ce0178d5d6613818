// SPDX-License-Identifier: Apache-2.0
#include "reports/results_json.h"

#include "compare/comparison_json.h"
#include "compare/fit_report.h"
#include "reports/equal_error.h"
#include "reports/frontier_page.h"
#include "reports/layer_statistics.h"
#include "reports/verdict.h"

namespace plumbline::reports {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const LayerError& error) {
    Json json = compare::to_json(error.comparison);
    json["reference_mean"] = error.reference_mean;
    json["test_mean"] = error.test_mean;
    json["mean_ratio"] = error.mean_ratio();
    return json;
}

Json json_of(const PictureErrors& errors) {
    return {{"radiance", json_of(errors.radiance)}, {"indirect", json_of(errors.indirect)}};
}

Json json_of(const ddgi::FrameFigures& figures) {
    return {{"bvh_ms", figures.bvh_ms},
            {"place_ms", figures.place_ms},
            {"light_ms", figures.light_ms},
            {"primary_ms", figures.primary_ms},
            {"probes", figures.probes},
            {"surfels", figures.surfels},
            {"surfels_hit", figures.surfels_hit},
            {"replaced", figures.replaced},
            {"shadow_rays", figures.shadow_rays},
            {"updates", figures.updates},
            {"relative_change", figures.relative_change},
            {"converged", figures.converged}};
}

Json json_of(const ModelRun& run) {
    return {{"id", run.id},
            {"title", run.title},
            {"model", run.options.model},
            {"command", run.command},
            {"surfels", run.options.surfels},
            {"set", run.options.set},
            {"seconds", run.result.seconds},
            {"frame_ms", run.frame_ms},
            {"notes", run.result.notes},
            {"figures", json_of(run.result.figures)},
            {"errors", json_of(run.errors)}};
}

Json truth_json(const SceneReport& scene) {
    const Image& image = scene.truth.image;
    return {{"command", scene.truth_command},
            {"spp", scene.truth.spp},
            {"seconds", scene.truth.seconds},
            {"rays", scene.truth.rays},
            {"relmse_estimate", scene.truth.relmse_estimate},
            {"mean",
             {{"radiance", layer_mean(image, "")},
              {"indirect", layer_mean(image, "indirect")},
              {"bounce1", layer_mean(image, "bounce1")}}},
            {"noise_rmse",
             {{"radiance", layer_noise(image, "")}, {"indirect", layer_noise(image, "indirect")}}}};
}

Json line_json(const SceneReport& scene) {
    const std::optional<PathTracerLine> line = path_tracer_line(scene);
    if (!line) return nullptr;
    Json equal_error = Json::object();
    for (const ModelRun& run : scene.models) {
        const std::optional<double> error = error_without_truth_noise(scene, run.errors.indirect);
        equal_error[run.id] = error ? Json(line->seconds_to(*error)) : Json(nullptr);
    }
    return {{"slope", line->slope}, {"equal_error_seconds", equal_error}};
}

Json fit_json(const SceneReport& scene) {
    if (!scene.fit) return nullptr;
    Json json = compare::to_json(scene.fit->result);
    json["seconds"] = scene.fit->seconds;
    return json;
}

Json animation_json(const SceneReport& scene) {
    if (!scene.animation) return nullptr;
    const AnimationErrors& animation = *scene.animation;
    Json models = Json::array();
    for (const MovingModel& model : animation.models) {
        Json errors = Json::array();
        for (std::size_t k = 0; k < model.errors.size(); ++k)
            errors.push_back({{"frame", animation.frames[k]},
                              {"rmse", model.errors[k].rmse},
                              {"bias_mse", model.errors[k].bias_mse},
                              {"mean_ratio", model.errors[k].mean_ratio}});
        models.push_back({{"title", model.title}, {"errors", errors}});
    }
    return {{"first", animation.first},
            {"last", animation.last},
            {"width", animation.width},
            {"height", animation.height},
            {"truth_spp", animation.truth_spp},
            {"updates", animation.updates},
            {"models", models}};
}

Json json_of(const SceneReport& scene) {
    Json models = Json::array();
    for (const ModelRun& run : scene.models) models.push_back(json_of(run));
    Json path_tracer = Json::array();
    for (const PathTracerRun& run : scene.path_tracer)
        path_tracer.push_back({{"spp", run.spp},
                               {"seconds", run.seconds},
                               {"rays", run.rays},
                               {"errors", json_of(run.errors)}});
    Json audits = Json::array();
    for (const compare::EnergyAudit& audit : scene.audits) audits.push_back(to_json(audit));
    Json effects = Json::array();
    for (const EffectReason& reason : scene.effects)
        effects.push_back(
            {{"effect", reason.effect}, {"simulated", reason.simulated}, {"why", reason.why}});
    return {{"scene", scene.name},
            {"description", scene.description},
            {"hash", scene.hash},
            {"frame", scene.frame},
            {"width", scene.truth.image.width()},
            {"height", scene.truth.image.height()},
            {"truth", truth_json(scene)},
            {"models", models},
            {"path_tracer", path_tracer},
            {"path_tracer_line", line_json(scene)},
            {"fit", fit_json(scene)},
            {"effects", effects},
            {"left_out", scene.left_out},
            {"animation", animation_json(scene)},
            {"frontier", scene.frontier ? frontier_json(*scene.frontier) : Json(nullptr)},
            {"audit", audits},
            {"verdict", verdict_of(scene).all()}};
}

}  // namespace

Json results_json(const Report& report) {
    Json scenes = Json::array();
    for (const SceneReport& scene : report.scenes) scenes.push_back(json_of(scene));
    return {{"version", report.version},
            {"date", report.date},
            {"command", report.command},
            {"quality", report.quality},
            {"machine",
             {{"cpu", report.machine.cpu},
              {"system", report.machine.system},
              {"threads", report.machine.threads}}},
            {"scenes", scenes},
            {"transfer", report.transfer ? compare::to_json(report.transfer->errors) : Json()},
            {"hard_cases", report.hard_cases.empty() ? Json() : to_json(report.hard_cases)},
            {"shared_fit", report.shared ? compare::to_json(*report.shared) : Json()}};
}

}  // namespace plumbline::reports
