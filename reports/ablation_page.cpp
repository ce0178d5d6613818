// SPDX-License-Identifier: Apache-2.0
#include "reports/ablation_page.h"

#include <fmt/core.h>

#include <cmath>

#include "reports/words.h"

namespace plumbline::reports {

namespace {

using nlohmann::ordered_json;

constexpr double bytes_per_megabyte = 1e6;

/// RMSE with the truth's own noise taken off; 0 where the noise explains it all.
double bias_rms(const AblationRow& row) { return std::sqrt(std::max(0., row.noise.bias_mse)); }

ordered_json row_json(const AblationRow& row) {
    return {{"group", row.subject.group},
            {"name", row.subject.name},
            {"title", row.subject.title},
            {"options", row.subject.options},
            {"mean_ratio", row.mean_ratio},
            {"rmse", row.metrics.rmse},
            {"relmse", row.metrics.relmse},
            {"mse_expected_from_noise", row.noise.mse_expected_from_noise},
            {"bias_mse", row.noise.bias_mse},
            {"bias_mse_ci95", row.noise.bias_mse_ci95},
            {"best_gain", row.best_gain},
            {"rmse_with_best_gain", row.rmse_with_gain},
            {"place_ms", row.place_ms},
            {"light_ms", row.light_ms},
            {"update_ms", row.update_ms},
            {"primary_ms", row.primary_ms},
            {"bytes", row.bytes},
            {"updates", row.updates},
            {"converged", row.converged},
            {"non_finite", row.non_finite},
            {"surfels_hit", row.surfels_hit},
            {"surfels_lit", row.surfels_lit},
            {"shadow_rays", row.shadow_rays}};
}

StudyTable group_table(const AblationScene& scene, const std::string& group) {
    StudyTable table{
        group,
        {"Case", "mean ratio to the truth", "RMSE", "RMSE without the truth's noise", "best gain",
         "RMSE with it", "placing, ms", "lighting, ms", "update, ms", "picture, ms", "memory, MB",
         "updates to converge", "surfels lit", "shadow rays"},
        {}};
    for (const AblationRow& row : scene.rows) {
        if (row.subject.group != group) continue;
        table.rows.push_back(
            {row.subject.title, number_text(row.mean_ratio), number_text(row.metrics.rmse),
             number_text(bias_rms(row)), number_text(row.best_gain),
             number_text(row.rmse_with_gain), number_text(row.place_ms), number_text(row.light_ms),
             number_text(row.update_ms), number_text(row.primary_ms),
             number_text(row.bytes / bytes_per_megabyte),
             row.converged ? std::to_string(row.updates) : fmt::format("not in {}", row.updates),
             count_text(row.surfels_lit), count_text(row.shadow_rays)});
    }
    return table;
}

std::vector<std::string> groups_of(const AblationScene& scene) {
    std::vector<std::string> groups;
    for (const AblationRow& row : scene.rows)
        if (groups.empty() || groups.back() != row.subject.group)
            groups.push_back(row.subject.group);
    return groups;
}

StudySection scene_section(const AblationScene& scene) {
    StudySection section{fmt::format("{}, frame {}", scene.name, scene.frame), {}, {}, {}, {}};
    StudyChart errors;
    errors.caption = "RMSE of the indirect layer without the truth's noise";
    errors.y_title = "RMSE";
    errors.log_y = true;
    StudySeries bars{"as it is", "series-0", {}, {}};
    StudySeries gained{"with the best gain, the truth's noise included", "series-2", {}, {}};
    StudyChart times;
    times.caption = "Error against the time of a probe update and a picture, both axes logarithmic";
    times.x_title = "milliseconds";
    times.y_title = "RMSE without the truth's noise";
    times.log_x = times.log_y = true;
    for (const AblationRow& row : scene.rows) {
        errors.labels.push_back(row.subject.name);
        bars.y.push_back(bias_rms(row));
        gained.y.push_back(row.rmse_with_gain);
    }
    errors.series = {bars, gained};
    std::size_t color = 0;
    for (const std::string& group : groups_of(scene)) {
        section.tables.push_back(group_table(scene, group));
        StudySeries points{group, fmt::format("series-{}", color++), {}, {}, false, true, false,
                           {}};
        for (const AblationRow& row : scene.rows) {
            if (row.subject.group != group) continue;
            points.x.push_back(row.update_ms + row.primary_ms);
            points.y.push_back(bias_rms(row));
            points.names.push_back(row.subject.name);
        }
        times.series.push_back(points);
    }
    section.charts = {errors, times};
    return section;
}

}  // namespace

ordered_json ablation_json(const std::vector<AblationScene>& scenes) {
    ordered_json list = ordered_json::array();
    for (const AblationScene& scene : scenes) {
        ordered_json cases = ordered_json::array();
        for (const AblationRow& row : scene.rows) cases.push_back(row_json(row));
        list.push_back({{"scene", scene.name},
                        {"frame", scene.frame},
                        {"width", scene.width},
                        {"height", scene.height},
                        {"cases", cases}});
    }
    return {{"scenes", list}};
}

std::string ablation_csv(const std::vector<AblationScene>& scenes) {
    std::string csv =
        "scene,frame,case,mean_ratio,rmse,mse_expected_from_noise,bias_mse,best_gain,"
        "rmse_with_best_gain,place_ms,light_ms,update_ms,primary_ms,bytes,updates,converged,"
        "surfels_hit,surfels_lit,shadow_rays\n";
    for (const AblationScene& scene : scenes) {
        for (const AblationRow& row : scene.rows)
            csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{:.0f},{},{:d},{},{},{}\n",
                               scene.name, scene.frame, row.subject.name, row.mean_ratio,
                               row.metrics.rmse, row.noise.mse_expected_from_noise,
                               row.noise.bias_mse, row.best_gain, row.rmse_with_gain, row.place_ms,
                               row.light_ms, row.update_ms, row.primary_ms, row.bytes, row.updates,
                               row.converged, row.surfels_hit, row.surfels_lit, row.shadow_rays);
    }
    return csv;
}

StudyPage ablation_page(const std::vector<AblationScene>& scenes, const std::string& command) {
    StudyPage page;
    page.title = "What each idea buys, and what it costs";
    page.command = command;
    page.lead = {
        "The indirect layer of converged stills against path tracing of all bounces. The best gain "
        "is the one number that, times the whole layer, leaves the least squared error: a case "
        "that only misses a scale is told from one that misses the distribution of light.",
        "Placing and lighting are of all surfels; an update is one pass over all probes; memory is "
        "what probes and surfels hold. Times are of one run each."};
    for (const AblationScene& scene : scenes) page.sections.push_back(scene_section(scene));
    return page;
}

}  // namespace plumbline::reports
