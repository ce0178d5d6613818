// SPDX-License-Identifier: Apache-2.0
#include "reports/frontier_page.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "reports/frontier_sentences.h"
#include "reports/words.h"

namespace plumbline::reports {

namespace {

constexpr double bytes_per_megabyte = 1e6;

std::vector<std::string> methods_of(const std::vector<TimedError>& points) {
    std::vector<std::string> methods;
    for (const TimedError& point : points)
        if (std::ranges::find(methods, point.method) == methods.end())
            methods.push_back(point.method);
    return methods;
}

/// Each method's pictures as dots, without a line.
StudySeries dots_of(const std::vector<TimedError>& points, const std::string& method,
                    const std::string& color) {
    StudySeries series{method, color, {}, {}, false, true, false, {}};
    for (const TimedError& point : points) {
        if (point.method != method) continue;
        series.x.push_back(point.seconds);
        series.y.push_back(point.error);
        series.names.push_back(point.setting);
    }
    return series;
}

/// As a staircase: an error is there from its time on.
StudySeries pareto_line(const std::vector<TimedError>& points, double most_seconds) {
    StudySeries line{"Pareto frontier", "ink", {}, {}, false, false, true, {}};
    for (const std::size_t i : pareto_set(points)) {
        if (!line.y.empty()) {
            line.x.push_back(points[i].seconds);
            line.y.push_back(line.y.back());
        }
        line.x.push_back(points[i].seconds);
        line.y.push_back(points[i].error);
    }
    line.x.push_back(most_seconds);
    line.y.push_back(line.y.back());
    return line;
}

StudySeries level(const std::string& label, const std::string& color, double error, double from,
                  double to) {
    return {label, color, {from, to}, {error, error}, true, false, true, {}};
}

StudyChart chart_of(const Frontier& frontier, const std::vector<TimedError>& points,
                    const std::string& caption) {
    StudyChart chart;
    chart.caption = caption;
    chart.x_title = "seconds";
    chart.y_title = "RMSE, the truth's noise taken off";
    chart.log_x = chart.log_y = true;
    const auto [quickest, slowest] = std::ranges::minmax_element(points, {}, &TimedError::seconds);
    const double from = quickest->seconds;
    const double to = slowest->seconds;
    std::size_t color = 0;
    for (const std::string& method : methods_of(points)) {
        const bool traced = method == path_tracer_method;
        const std::string own = traced ? "path" : fmt::format("series-{}", color++);
        chart.series.push_back(dots_of(points, method, own));
        if (traced) continue;
        for (const ErrorFloor& floor : error_floors(points))
            if (floor.floor.method == method)
                chart.series.push_back(
                    level("least of " + method, own, floor.floor.error, from, to));
    }
    if (const auto law = fit_error_law(points, path_tracer_method))
        chart.series.push_back({fmt::format("seconds^{:.3f}", law->law.exponent),
                                "path",
                                {from, to},
                                {law->error_after(from), law->error_after(to)},
                                true});
    chart.series.push_back(pareto_line(points, to));
    chart.series.push_back(level("noise of the truth", "truth", frontier.truth_noise, from, to));
    return chart;
}

std::string spread_text(const Spread& spread) {
    return fmt::format("{} ({} to {})", number_text(spread.median), number_text(spread.least),
                       number_text(spread.most));
}

StudyTable pareto_table(const std::vector<TimedError>& points) {
    StudyTable table{"The Pareto frontier: no other picture is both as quick and as exact",
                     {"Method", "setting", "seconds", "RMSE"},
                     {}};
    for (const std::size_t i : pareto_set(points))
        table.rows.push_back({points[i].method, points[i].setting, number_text(points[i].seconds),
                              number_text(points[i].error)});
    return table;
}

StudyTable all_points(const Frontier& frontier) {
    StudyTable table{
        "Every picture: medians, and least to most of the repeats",
        {"Method", "setting", "RMSE", "noise (MSE)", "bias\u00b2", "bias\u00b2, 95 %", "a still, s",
         "one more frame, s", "placing, ms", "update, ms", "picture, ms", "memory, MB"},
        {}};
    for (const FrontierPoint& point : frontier.points)
        table.rows.push_back(
            {point.method, point.setting,
             point.error ? spread_text(*point.error) : "below the truth's noise",
             number_text(point.noise_mse), number_text(point.bias_mse),
             fmt::format("{} to {}", number_text(point.bias_mse_ci95[0]),
                         number_text(point.bias_mse_ci95[1])),
             spread_text(point.seconds),
             point.frame_seconds ? spread_text(*point.frame_seconds) : "not settled",
             number_text(point.place_ms.median), number_text(point.update_ms.median),
             number_text(point.primary_ms.median), number_text(point.bytes / bytes_per_megabyte)});
    return table;
}

StudySection budget_section(const Frontier& frontier, Budget budget, const std::string& heading,
                            const std::string& caption) {
    const std::vector<TimedError> points = timed_errors(frontier, budget);
    StudySection section{heading, {}, {}, {}, {}};
    if (points.empty()) {
        section.paragraphs = {"No picture's error exceeds the noise of the truth."};
        return section;
    }
    section.charts = {chart_of(frontier, points, caption)};
    section.tables = {pareto_table(points)};
    return section;
}

}  // namespace

std::vector<StudySection> frontier_sections(const Frontier& frontier) {
    return {budget_section(
                frontier, Budget::Still, "A still from nothing",
                "Error against the time of a still from nothing, both axes logarithmic; "
                "dashed: each method's least error, the power law of the path tracer, and the "
                "noise of the truth"),
            budget_section(frontier, Budget::Frame, "One more frame",
                           "Error against the time of one more frame, the probes settled, the path "
                           "tracer beginning anew"),
            {"Every picture", {}, {all_points(frontier)}, {}, {}}};
}

StudyPage frontier_page(const Frontier& frontier, const std::string& command) {
    StudyPage page;
    page.title = "What accuracy costs in time: " + frontier.scene;
    page.command = command;
    page.lead = frontier_sentences(frontier);
    page.lead.push_back(fmt::format(
        "Frame {} at {} x {}, the indirect layer against path tracing of all bounces. Medians of "
        "{} repeats; those of the path tracer have independent seeds, which tell its noise from "
        "bias. The work for probes does not depend on the size of the picture, that for the "
        "picture does.",
        frontier.frame, frontier.width, frontier.height, frontier.repeats));
    page.sections = frontier_sections(frontier);
    return page;
}

}  // namespace plumbline::reports
