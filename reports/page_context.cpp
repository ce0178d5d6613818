// SPDX-License-Identifier: Apache-2.0
#include "reports/page_context.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "compare/metrics.h"
#include "reports/equal_error.h"
#include "reports/page_files.h"
#include "reports/picture_context.h"
#include "reports/scene_sections.h"
#include "reports/study_section.h"
#include "reports/tables.h"
#include "reports/verdict.h"
#include "reports/words.h"

namespace plumbline::reports {

namespace {

using nlohmann::json;

/// In the order in which they build on each other.
constexpr std::array scripts{
    "chart.min.js", "theme.js",           "tables.js",      "layers.js",
    "display.js",   "viewer_controls.js", "viewer_view.js", "viewer_inspector.js",
    "viewer.js",    "viewer_input.js",    "charts.js",      "study.js"};

/// What the reader of any report has to keep in mind.
constexpr std::array limits{
    "All surfaces are Lambertian: no gloss, mirrors, glass, participating media, motion or lens "
    "blur.",
    "The truth is itself a Monte Carlo estimate: errors below its noise, given in each verdict, "
    "cannot be seen. More samples (--spp of the render command) lower it by their square root.",
    "The split into noise and bias takes pixels as independent and their variances as exact.",
    "Times are wall-clock times of one run each on this machine, with whatever else it was doing.",
    "The fitted constants are the best for this scene, frame and view; another may want others.",
};

/// Of a stacked bar or a gauge, which end at 0 and 100 %.
std::string width_text(double share) {
    return fmt::format("{:.1f}", 100 * std::clamp(share, 0., 1.));
}

json split_context(const LayerError& error) {
    const std::optional<compare::NoiseSplit>& noise = error.comparison.noise;
    if (!noise || error.mse() == 0) return nullptr;
    const auto share = [&](double square) { return square / error.mse(); };
    return {{"bias_width", width_text(share(noise->bias_mse))},
            {"bias_share", percent_text(share(noise->bias_mse))},
            {"interval", fmt::format("{} to {}", percent_text(share(noise->bias_mse_ci95[0])),
                                     percent_text(share(noise->bias_mse_ci95[1])))}};
}

json ladder_row(const ModelRun& run, std::size_t index, bool best) {
    const LayerError& error = run.errors.indirect;
    const double rmse = error.comparison.metrics.rmse;
    // The gauge runs to twice the truth.
    return {{"title", run.title},
            {"color", model_color(index)},
            {"best", best},
            {"gauge", width_text(error.mean_ratio() / 2)},
            {"share", percent_text(error.mean_ratio())},
            {"rmse", number_text(rmse)},
            {"rmse_relative", percent_text(rmse / error.reference_mean)},
            {"split", split_context(error)},
            {"frame_time", duration_text(run.frame_ms / 1e3)},
            {"total_time", duration_text(run.result.seconds)}};
}

json effects_context(const SceneReport& report) {
    json effects = json::array();
    for (const EffectReason& reason : report.effects)
        effects.push_back({{"effect", reason.effect},
                           {"simulated", reason.simulated ? "yes" : "no"},
                           {"why", reason.why}});
    return effects;
}

json commands_context(const SceneReport& report) {
    json commands = json::array({{{"command", report.truth_command}}});
    for (const ModelRun& run : report.models) {
        commands.push_back({{"command", run.command}});
        commands.push_back(
            {{"command",
              fmt::format("plumbline compare truth.exr {}.exr --layer indirect", run.id)}});
    }
    return commands;
}

std::string slope_text(const SceneReport& report) {
    const std::optional<PathTracerLine> line = path_tracer_line(report);
    if (!line) return "";
    return fmt::format(
        "The path tracer's measured slope is {:.2f} (independent samples give \u22120.5).",
        line->slope);
}

/// Values that were left out of the metrics, a line each.
json non_finite_context(const SceneReport& report) {
    json lines = json::array();
    for (const ModelRun& run : report.models) {
        const std::size_t count = run.errors.radiance.comparison.non_finite;
        if (count > 0)
            lines.push_back(fmt::format("{}: {} values are not finite and left out of the figures.",
                                        run.title, count));
    }
    return lines;
}

/// What was left out of the report, and what the models want a user to know.
std::vector<std::string> notes_of(const SceneReport& report) {
    std::vector<std::string> notes = report.left_out;
    for (const ModelRun& run : report.models)
        for (const std::string& note : run.result.notes) notes.push_back(run.title + ": " + note);
    return notes;
}

json sections_context(const std::vector<StudySection>& sections, const std::string& level,
                      json& charts) {
    json list = json::array();
    for (const StudySection& section : sections)
        list.push_back(section_context(section, level, charts));
    return list;
}

json scene_context(const SceneReport& report, std::size_t index, int block, json& charts) {
    const Verdict verdict = verdict_of(report);
    json models = json::array();
    for (std::size_t i = 0; i < report.models.size(); ++i)
        models.push_back(ladder_row(report.models[i], i, &report.models[i] == verdict.best));
    const std::vector<std::string> notes = notes_of(report);
    json context = picture_context(report, block);
    context.update({{"anchor", fmt::format("scene-{}", index)},
                    {"index", index},
                    {"name", report.name},
                    {"description", report.description},
                    {"frame", report.frame},
                    {"width", report.truth.image.width()},
                    {"height", report.truth.image.height()},
                    {"hash", report.hash},
                    {"export_command",
                     fmt::format("plumbline export {} -o scene.json", shell_word(report.argument))},
                    {"headline", verdict.headline},
                    {"sentences", verdict.sentences},
                    {"models", models},
                    {"metrics", {metrics_table(report, "indirect"), metrics_table(report, "")}},
                    {"times", times_table(report)},
                    {"sections", sections_context(scene_sections(report), "h3", charts)},
                    {"fit", constants_table(report)},
                    {"effects", effects_context(report)},
                    {"has_notes", !notes.empty()},
                    {"notes", notes},
                    {"commands", commands_context(report)},
                    {"non_finite", non_finite_context(report)},
                    {"slope", slope_text(report)}});
    return context;
}

/// What several scenes tell together.
std::vector<StudySection> between_scenes(const Report& report) {
    std::vector<StudySection> sections;
    if (report.transfer) sections.push_back(transfer_section(*report.transfer));
    if (!report.hard_cases.empty()) sections.push_back(stress_section(report.hard_cases));
    return sections;
}

json formulas_context() {
    json formulas = json::array();
    for (const compare::MetricDescription& metric : compare::metric_descriptions())
        formulas.push_back({{"name", metric.name}, {"formula", metric.formula}});
    return formulas;
}

json scripts_context() {
    json texts = json::array();
    for (const char* name : scripts) texts.push_back({{"text", page_file(name)}});
    return texts;
}

}  // namespace

json page_context(const Report& report, int block, json& charts) {
    json scenes = json::array();
    std::string title;
    for (std::size_t i = 0; i < report.scenes.size(); ++i) {
        scenes.push_back(scene_context(report.scenes[i], i, block, charts));
        title += (title.empty() ? "" : ", ") + report.scenes[i].name;
    }
    return {{"version", report.version},
            {"date", report.date},
            {"quality", report.quality},
            {"command", report.command},
            {"title", title},
            {"machine",
             {{"cpu", report.machine.cpu},
              {"system", report.machine.system},
              {"threads", report.machine.threads}}},
            {"style", page_style()},
            {"scripts", scripts_context()},
            {"scenes", scenes},
            {"has_between", !between_scenes(report).empty()},
            {"between", sections_context(between_scenes(report), "h2", charts)},
            {"formulas", formulas_context()},
            {"limits", limits}};
}

}  // namespace plumbline::reports
