// SPDX-License-Identifier: Apache-2.0
#include "reports/tables.h"

#include <fmt/core.h>

#include <cmath>
#include <functional>
#include <optional>

#include "compare/metrics.h"
#include "reports/words.h"

namespace plumbline::reports {

namespace {

using nlohmann::json;

/// style.css has this many colours for models.
constexpr std::size_t model_colors = 6;

constexpr const char* no_value = "\u2013";

json cell(std::optional<double> value, const std::string& text, const std::string& note = "") {
    const bool sorts = value && std::isfinite(*value);
    return {{"value", sorts ? fmt::format("{}", *value) : ""},
            {"text", value ? text : no_value},
            {"note", note.empty() ? json(false) : json(note)}};
}

json number_cell(std::optional<double> value) {
    return cell(value, number_text(value.value_or(0)));
}

json seconds_cell(std::optional<double> seconds) {
    return cell(seconds, duration_text(seconds.value_or(0)));
}

json count_cell(std::optional<std::uint64_t> count) {
    return cell(count, count_text(count.value_or(0)));
}

json metric_cells(const LayerError& error, double seconds) {
    json cells{seconds_cell(seconds), number_cell(error.mean_ratio())};
    for (const compare::MetricDescription& metric : compare::metric_descriptions())
        cells.push_back(number_cell(metric.value(error.comparison.metrics)));
    if (const std::optional<compare::NoiseSplit>& noise = error.comparison.noise) {
        const auto& [low, high] = noise->bias_mse_ci95;
        cells.push_back(number_cell(noise->mse_expected_from_noise));
        cells.push_back(cell(noise->bias_mse, number_text(noise->bias_mse),
                             fmt::format("{} to {}", number_text(low), number_text(high))));
        cells.push_back(cell(noise->z_fraction_above_3, percent_text(noise->z_fraction_above_3)));
    } else {
        for (int column = 0; column < 3; ++column) cells.push_back(cell({}, ""));
    }
    return cells;
}

std::string path_tracer_title(const PathTracerRun& run) {
    return fmt::format("path tracer, {} spp", run.spp);
}

json row(const std::string& title, const std::string& color, json cells) {
    return {{"title", title}, {"color", color}, {"cells", std::move(cells)}};
}

/// What the thesis's model ran with when its constants were as published; a dash if it did not run.
std::string published_text(const SceneReport& report, const std::string& constant) {
    for (const ModelRun& run : report.models)
        if (run.options.model == "thesis" && run.options.set.empty())
            if (const auto found = run.result.constants.find(constant);
                found != run.result.constants.end())
                return number_text(found->second);
    return no_value;
}

std::string constant_verdict(const compare::FittedConstant& constant) {
    return constant.identifiable ? "yes" : "no, only together with others";
}

std::string error_text(double standard_error) {
    return std::isfinite(standard_error) ? "\u00b1 " + number_text(standard_error) : "unbounded";
}

/// 95 % of a normal distribution.
std::string interval_text(double value, double standard_error) {
    if (!std::isfinite(standard_error)) return "unbounded";
    return fmt::format("{} to {}", number_text(value - 1.96 * standard_error),
                       number_text(value + 1.96 * standard_error));
}

}  // namespace

std::string model_color(std::size_t index) {
    return fmt::format("series-{}", index % model_colors);
}

json metrics_table(const SceneReport& report, const std::string& layer) {
    const bool whole = layer.empty();
    json columns{"seconds", "mean ratio"};
    for (const compare::MetricDescription& metric : compare::metric_descriptions())
        columns.push_back(metric.name);
    for (const char* name : {"noise (MSE)", "bias\u00b2, 95 %", "|z| > 3"}) columns.push_back(name);
    json rows = json::array();
    const auto of = [&](const PictureErrors& errors) -> const LayerError& {
        return whole ? errors.radiance : errors.indirect;
    };
    for (std::size_t i = 0; i < report.models.size(); ++i) {
        const ModelRun& run = report.models[i];
        rows.push_back(
            row(run.title, model_color(i), metric_cells(of(run.errors), run.result.seconds)));
    }
    for (const PathTracerRun& run : report.path_tracer)
        rows.push_back(
            row(path_tracer_title(run), "path", metric_cells(of(run.errors), run.seconds)));
    return {{"layer", whole ? "Whole picture (radiance)" : "Indirect light"},
            {"columns", columns},
            {"rows", rows}};
}

json times_table(const SceneReport& report) {
    json rows = json::array();
    const auto ms = [](double milliseconds) { return seconds_cell(milliseconds / 1e3); };
    for (std::size_t i = 0; i < report.models.size(); ++i) {
        const ModelRun& run = report.models[i];
        const ddgi::FrameFigures& f = run.result.figures;
        rows.push_back(row(run.title, model_color(i),
                           {number_cell(run.errors.indirect.comparison.metrics.rmse),
                            seconds_cell(run.result.seconds), ms(run.frame_ms), ms(f.place_ms),
                            ms(f.light_ms), count_cell(static_cast<std::uint64_t>(f.updates)),
                            ms(f.primary_ms), count_cell(f.probes), count_cell(f.surfels),
                            count_cell(f.surfels_hit), count_cell(f.shadow_rays)}));
    }
    const auto path_tracer_row = [&](const std::string& title, const std::string& color,
                                     std::optional<double> rmse, double seconds,
                                     std::uint64_t rays) {
        json cells{number_cell(rmse), seconds_cell(seconds)};
        for (int column = 0; column < 8; ++column) cells.push_back(cell({}, ""));
        cells.push_back(count_cell(rays));
        rows.push_back(row(title, color, cells));
    };
    for (const PathTracerRun& run : report.path_tracer)
        path_tracer_row(path_tracer_title(run), "path", run.errors.indirect.comparison.metrics.rmse,
                        run.seconds, run.rays);
    path_tracer_row(fmt::format("truth, {} spp", report.truth.spp), "truth", {},
                    report.truth.seconds, report.truth.rays);
    return {{"columns",
             {"RMSE", "in all", "one frame", "place", "light", "updates", "primary", "probes",
              "surfels", "surfels hit", "rays"}},
            {"rows", rows}};
}

json constants_table(const SceneReport& report) {
    if (!report.fit) return nullptr;
    const compare::FitResult& fit = report.fit->result;
    json constants = json::array();
    for (const compare::FittedConstant& constant : fit.constants)
        constants.push_back({{"name", constant.name},
                             {"published", published_text(report, constant.name)},
                             {"value", number_text(constant.value)},
                             {"standard_error", error_text(constant.standard_error)},
                             {"interval", interval_text(constant.value, constant.standard_error)},
                             {"verdict", constant_verdict(constant)}});
    for (const compare::KnownCombination& combination : fit.combinations)
        constants.push_back(
            {{"name", combination.expression},
             {"published", no_value},
             {"value", number_text(combination.value)},
             {"standard_error", error_text(combination.standard_error)},
             {"interval", interval_text(combination.value, combination.standard_error)},
             {"verdict", "yes"}});
    return {{"summary",
             fmt::format("Fitted in {}: RMSE (indirect) {} before, {} after; reduced chi-square {} "
                         "(1 if noise explained all that is left). The best single gain on the "
                         "published picture is {} \u00b1 {} and leaves an RMSE of {}.",
                         duration_text(report.fit->seconds), number_text(fit.rmse_before),
                         number_text(fit.rmse_after), number_text(fit.reduced_chi_square),
                         number_text(fit.gain), number_text(fit.gain_standard_error),
                         number_text(fit.rmse_gain))},
            {"constants", constants},
            {"notes", fit.notes}};
}

}  // namespace plumbline::reports
