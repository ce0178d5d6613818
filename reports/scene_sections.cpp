// SPDX-License-Identifier: Apache-2.0
#include "reports/scene_sections.h"

#include <fmt/core.h>

#include <cmath>

#include "reports/frontier_page.h"
#include "reports/frontier_sentences.h"
#include "reports/tables.h"
#include "reports/words.h"

namespace plumbline::reports {

namespace {

/// A picture's error at each width of block, and beside it what independent noise would leave.
void add_scales(StudySection& section, const std::string& title, const std::string& color,
                const std::vector<compare::ScaleError>& scales) {
    StudySeries measured{title, color, {}, {}, false, true, true, {}};
    StudySeries noise{title + ", if noise", color, {}, {}, true, false, true, {}};
    std::vector<std::string> row{title};
    for (const compare::ScaleError& scale : scales) {
        for (StudySeries* series : {&measured, &noise}) series->x.push_back(scale.width);
        measured.y.push_back(scale.rmse);
        noise.y.push_back(scale.if_noise);
        row.push_back(number_text(scale.rmse));
    }
    section.charts[0].series.push_back(measured);
    section.charts[0].series.push_back(noise);
    row.resize(section.tables[0].head.size() - 2);
    const auto slope = compare::scale_slope(scales);
    row.push_back(slope ? fmt::format("{:.2f}", *slope) : "none");
    row.push_back(compare::scale_verdict(scales));
    section.tables[0].rows.push_back(row);
}

/// Nothing without pictures.
StudySection scales_section(const SceneReport& report) {
    StudySection section{
        "Error by scale",
        {"RMSE of the means over square blocks of pixels, indirect layer. Independent noise halves "
         "with each doubling of the block, as the dashed line of the same colour does; what stays "
         "above it is structure or bias, which figures for single pixels hide."},
        {{"RMSE of block means", {"Picture"}, {}}},
        {{"Error of block means against the width of the block, both axes logarithmic; dashed: if "
          "all of it were noise",
          "width of the block, pixels",
          "RMSE of the means",
          {},
          {},
          {},
          true,
          true}},
        {}};
    const auto& widest = report.models.front().errors.indirect.comparison.scales;
    for (const compare::ScaleError& scale : widest)
        section.tables[0].head.push_back(fmt::format("{}", scale.width));
    section.tables[0].head.emplace_back("slope");
    section.tables[0].head.emplace_back("what it is");
    for (std::size_t i = 0; i < report.models.size(); ++i)
        add_scales(section, report.models[i].title, model_color(i),
                   report.models[i].errors.indirect.comparison.scales);
    if (!report.path_tracer.empty()) {
        const PathTracerRun& most = report.path_tracer.back();
        add_scales(section, fmt::format("path tracer, {} spp", most.spp), "path",
                   most.errors.indirect.comparison.scales);
    }
    return section;
}

/// RMSE without the truth's noise; not a number where the noise explains it all.
double error_of(const MovingError& error) { return std::sqrt(error.bias_mse); }

std::string error_text(const MovingError& error) {
    return error.bias_mse > 0 ? number_text(error_of(error)) : "below the truth's noise";
}

StudyTable moving_table(const AnimationErrors& animation) {
    StudyTable table{"Error and mean ratio over the frames", {"Frame"}, {}};
    for (const MovingModel& model : animation.models)
        for (const char* what : {", RMSE", ", mean ratio"})
            table.head.push_back(model.title + what);
    for (std::size_t k = 0; k < animation.frames.size(); ++k) {
        std::vector<std::string> row{fmt::format("{}", animation.frames[k])};
        for (const MovingModel& model : animation.models) {
            row.push_back(error_text(model.errors[k]));
            row.push_back(number_text(model.errors[k].mean_ratio));
        }
        table.rows.push_back(row);
    }
    return table;
}

std::string invented_text(const compare::BounceEnergy& bounce) {
    if (!(bounce.reflected > 0)) return "none to reflect";
    return fmt::format("{:+.1f} % \u00b1 {:.1f}", 100 * bounce.invented / bounce.reflected,
                       100 * bounce.standard_error / bounce.reflected);
}

StudySection time_section(const SceneReport& report) {
    StudySection section{
        "What accuracy costs in time", frontier_sentences(*report.frontier), {}, {}, {}};
    section.paragraphs.push_back(fmt::format(
        "Measured at {} x {} by plumbline frontier {} --quick -o out/frontier; medians of {} "
        "repeats.",
        report.frontier->width, report.frontier->height, shell_word(report.argument),
        report.frontier->repeats));
    return section;
}

}  // namespace

StudySection animation_section(const AnimationErrors& animation) {
    StudyChart chart{
        "RMSE of the indirect layer over the frames, logarithmic, the truth's noise "
        "taken off; vertical lines: where the motion begins and ends",
        "frame",
        "RMSE, indirect",
        {},
        {},
        {double(animation.first), double(animation.last)},
        false,
        true};
    for (std::size_t i = 0; i < animation.models.size(); ++i) {
        StudySeries series{
            animation.models[i].title, model_color(i), {}, {}, false, true, true, {}};
        for (std::size_t k = 0; k < animation.frames.size(); ++k) {
            series.x.push_back(animation.frames[k]);
            series.y.push_back(error_of(animation.models[i].errors[k]));
        }
        chart.series.push_back(series);
    }
    return {"The error over the animation",
            {fmt::format(
                "Played as a viewer sees it, from settled probes, in steps of {} frames with {} "
                "probe updates each; the last frames stand still. At {} x {}, each frame against "
                "its own truth of {} samples a pixel.",
                animation.frames.size() > 1 ? animation.frames[1] - animation.frames[0] : 1,
                animation.updates, animation.width, animation.height, animation.truth_spp)},
            {moving_table(animation)},
            {chart},
            {}};
}

StudySection audit_section(const std::vector<compare::EnergyAudit>& audits) {
    StudySection section{
        "Where the energy goes",
        {"Flux of each indirect bounce over all surfaces, in W, mean of the channels: what arrives "
         "by ray casting of the bounce before, what of it should leave, and what the model shows. "
         "The last column is what it invents or, below 0, loses, of what should have left."},
        {},
        {},
        {}};
    for (const compare::EnergyAudit& audit : audits) {
        StudyTable table{
            fmt::format("{}: direct and emitted {}, ambient invented {}", audit.model,
                        number_text(audit.direct), number_text(audit.ambient)),
            {"Bounce", "arriving", "absorbed", "to reflect", "shown", "invented or lost"},
            {}};
        for (const compare::BounceEnergy& one : audit.bounces)
            table.rows.push_back({fmt::format("{}", one.bounce), number_text(one.arriving),
                                  number_text(one.absorbed), number_text(one.reflected),
                                  number_text(one.shown), invented_text(one)});
        section.tables.push_back(table);
    }
    return section;
}

std::vector<StudySection> scene_sections(const SceneReport& report) {
    std::vector<StudySection> sections;
    if (!report.models.empty()) sections.push_back(scales_section(report));
    if (report.animation) sections.push_back(animation_section(*report.animation));
    if (report.frontier) {
        sections.push_back(time_section(report));
        for (StudySection& section : frontier_sections(*report.frontier))
            sections.push_back(std::move(section));
    }
    if (!report.audits.empty()) sections.push_back(audit_section(report.audits));
    return sections;
}

}  // namespace plumbline::reports
