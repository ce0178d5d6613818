// SPDX-License-Identifier: Apache-2.0
#include "reports/budget_page.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "reports/words.h"

namespace plumbline::reports {

namespace {

using nlohmann::ordered_json;

/// Colours that style.css has for lines; curves beyond are dashed.
constexpr std::size_t colors = 6;

std::string title_of(const BudgetRun& run) {
    return run.budget ? fmt::format("{} surfels a frame", count_text(std::uint64_t(*run.budget)))
                      : "no budget";
}

/// RMSE without the truth's noise; what is below it counts as none.
double rmse_of(const MovingError& error) { return std::sqrt(std::max(0., error.bias_mse)); }

/// Figures of one budget; means over the frames from the first key to the last.
struct BudgetMeans {
    double update_ms = 0, replaced = 0, shadow_rays = 0, lag = 0;
    double rmse = 0, mean_ratio = 0;
    double most_lag = 0;
    std::uint64_t most_replaced = 0, most_waiting = 0;
    int longest_wait = 0;
    /// From the last key until no surfel waits; none: they still do.
    std::optional<int> frames_to_settle;
};

BudgetMeans means_of(const BudgetStudy& study, const BudgetRun& run) {
    BudgetMeans means;
    double moving = 0;
    for (std::size_t i = 0; i < run.frames.size(); ++i) {
        const BudgetFrame& frame = run.frames[i];
        means.most_replaced = std::max(means.most_replaced, frame.replaced);
        means.most_waiting = std::max(means.most_waiting, frame.waiting);
        means.longest_wait = std::max(means.longest_wait, frame.oldest_wait);
        means.most_lag = std::max(means.most_lag, frame.lag);
        if (study.frames[i] >= study.last && frame.waiting == 0 && !means.frames_to_settle)
            means.frames_to_settle = study.frames[i] - study.last;
        if (study.frames[i] == study.first || study.frames[i] > study.last) continue;
        ++moving;
        means.update_ms += frame.update_ms;
        means.replaced += static_cast<double>(frame.replaced);
        means.shadow_rays += static_cast<double>(frame.shadow_rays);
        means.lag += frame.lag;
    }
    for (double* mean : {&means.update_ms, &means.replaced, &means.shadow_rays, &means.lag})
        *mean /= moving;
    double held = 0;
    for (std::size_t i = 0; i < run.errors.size(); ++i) {
        if (study.held[i] > study.last) continue;
        ++held;
        means.rmse += rmse_of(run.errors[i]);
        means.mean_ratio += run.errors[i].mean_ratio;
    }
    means.rmse /= held;
    means.mean_ratio /= held;
    return means;
}

StudyTable means_table(const BudgetStudy& study) {
    StudyTable table{"Means over the frames in which something moves",
                     {"Budget", "probe update, ms", "surfels re-placed", "shadow rays",
                      "mean ratio to the truth", "RMSE without the truth's noise", "lag",
                      "largest lag", "most waiting", "longest wait, frames", "frames to settle"},
                     {}};
    for (const BudgetRun& run : study.runs) {
        const BudgetMeans means = means_of(study, run);
        table.rows.push_back(
            {title_of(run), number_text(means.update_ms), number_text(means.replaced),
             number_text(means.shadow_rays), number_text(means.mean_ratio), number_text(means.rmse),
             number_text(means.lag), number_text(means.most_lag), count_text(means.most_waiting),
             std::to_string(means.longest_wait),
             means.frames_to_settle ? std::to_string(*means.frames_to_settle) : "more"});
    }
    return table;
}

StudySeries series_of(const BudgetStudy& study, std::size_t run) {
    return {
        title_of(study.runs[run]), fmt::format("series-{}", run % colors), {}, {}, run >= colors};
}

template <typename Value>
StudyChart frames_chart(const BudgetStudy& study, const std::string& caption,
                        const std::string& y_title, const Value& value) {
    StudyChart chart;
    chart.caption = caption;
    chart.x_title = "frame";
    chart.y_title = y_title;
    chart.marks = {double(study.first), double(study.last)};
    for (std::size_t run = 0; run < study.runs.size(); ++run) {
        StudySeries series = series_of(study, run);
        for (std::size_t i = 0; i < study.frames.size(); ++i) {
            series.x.push_back(study.frames[i]);
            series.y.push_back(value(study.runs[run].frames[i]));
        }
        chart.series.push_back(series);
    }
    return chart;
}

StudyChart errors_chart(const BudgetStudy& study) {
    StudyChart chart;
    chart.caption =
        "Error of the indirect layer, each frame against its own truth, noise taken off";
    chart.x_title = "frame";
    chart.y_title = "RMSE";
    chart.marks = {double(study.first), double(study.last)};
    for (std::size_t run = 0; run < study.runs.size(); ++run) {
        StudySeries series = series_of(study, run);
        series.dots = true;
        for (std::size_t i = 0; i < study.held.size(); ++i) {
            series.x.push_back(study.held[i]);
            series.y.push_back(rmse_of(study.runs[run].errors[i]));
        }
        chart.series.push_back(series);
    }
    return chart;
}

}  // namespace

ordered_json budget_json(const BudgetStudy& study) {
    ordered_json budgets = ordered_json::array();
    for (const BudgetRun& run : study.runs) {
        const BudgetMeans means = means_of(study, run);
        ordered_json one;
        one["budget"] = run.budget ? ordered_json(*run.budget) : ordered_json();
        one["update_ms_moving"] = means.update_ms;
        one["replaced_moving"] = means.replaced;
        one["shadow_rays_moving"] = means.shadow_rays;
        one["most_replaced"] = means.most_replaced;
        one["most_waiting"] = means.most_waiting;
        one["longest_wait"] = means.longest_wait;
        one["rmse_moving"] = means.rmse;
        one["mean_ratio_moving"] = means.mean_ratio;
        one["lag_moving"] = means.lag;
        one["most_lag"] = means.most_lag;
        one["frames_to_settle"] =
            means.frames_to_settle ? ordered_json(*means.frames_to_settle) : ordered_json();
        budgets.push_back(one);
    }
    return {{"model", study.model},         {"width", study.width},     {"height", study.height},
            {"truth_spp", study.truth_spp}, {"surfels", study.surfels}, {"first", study.first},
            {"last", study.last},           {"budgets", budgets}};
}

std::string budget_csv(const BudgetStudy& study) {
    std::string csv =
        "budget,frame,update_ms,replaced,shadow_rays,waiting,oldest_wait,lag,mean_ratio,rmse,"
        "bias_mse\n";
    for (const BudgetRun& run : study.runs) {
        std::size_t held = 0;
        for (std::size_t i = 0; i < run.frames.size(); ++i) {
            const BudgetFrame& frame = run.frames[i];
            csv += fmt::format("{},{},{},{},{},{},{},{}", run.budget.value_or(0), study.frames[i],
                               frame.update_ms, frame.replaced, frame.shadow_rays, frame.waiting,
                               frame.oldest_wait, frame.lag);
            if (held < study.held.size() && study.held[held] == study.frames[i]) {
                const MovingError& error = run.errors[held++];
                csv += fmt::format(",{},{},{}\n", error.mean_ratio, error.rmse, error.bias_mse);
            } else {
                csv += ",,,\n";
            }
        }
    }
    return csv;
}

StudyPage budget_page(const BudgetStudy& study, const std::string& scene,
                      const std::string& command) {
    StudySection section{"Budgets", {}, {means_table(study)}, {}, {}};
    section.paragraphs.emplace_back(
        "Dashed vertical lines stand where the animation begins and ends.");
    section.charts = {
        errors_chart(study),
        frames_chart(study, "Lag: RMSE of the indirect layer against the frame without a budget",
                     "RMSE", [](const BudgetFrame& frame) { return frame.lag; }),
        frames_chart(study, "Probe update", "milliseconds",
                     [](const BudgetFrame& frame) { return frame.update_ms; }),
        frames_chart(study, "Surfels re-placed", "surfels",
                     [](const BudgetFrame& frame) { return double(frame.replaced); }),
        frames_chart(study, "Surfels that wait for their turn", "surfels",
                     [](const BudgetFrame& frame) { return double(frame.waiting); })};
    return {"Work spread over frames: " + scene,
            command,
            {fmt::format("Model {}, {} surfels, pictures of {} x {}, truths of {} samples a pixel. "
                         "Of the surfels that something touched, a frame re-places or lights again "
                         "no more than its budget, those first that wait longest and changed most; "
                         "the others stay as they were. Times are of one run.",
                         study.model, count_text(study.surfels), study.width, study.height,
                         study.truth_spp)},
            {section}};
}

}  // namespace plumbline::reports
