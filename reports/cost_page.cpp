// SPDX-License-Identifier: Apache-2.0
#include "reports/cost_page.h"

#include <fmt/core.h>

#include "reports/machine.h"

namespace plumbline::reports {

namespace {

using nlohmann::ordered_json;

ordered_json law_json(const std::optional<PowerLaw>& law) {
    if (!law) return nullptr;
    return {
        {"exponent", law->exponent}, {"exponent_ci95", law->exponent_ci95}, {"scale", law->scale}};
}

ordered_json sweep_json(const CostSweep& sweep) {
    ordered_json points = ordered_json::array();
    for (const CostPoint& point : sweep.points)
        points.push_back({{"spacing", point.spacing},
                          {"per_probe", point.per_probe},
                          {"probes", point.probes},
                          {"place_ms", point.place_ms},
                          {"light_ms", point.light_ms},
                          {"update_ms", point.update_ms},
                          {"bytes", point.bytes}});
    return {{"points", points},
            {"place", law_json(sweep.place)},
            {"update", law_json(sweep.update)},
            {"total", law_json(sweep.total)},
            {"bytes", law_json(sweep.bytes)}};
}

std::string law_text(const std::optional<PowerLaw>& law) {
    if (!law) return "none";
    return fmt::format("{:.3f} ({:.3f} to {:.3f})", law->exponent, law->exponent_ci95[0],
                       law->exponent_ci95[1]);
}

StudySection sweep_section(const CostSweep& sweep) {
    StudyTable table{"Least time of the repeats, and what is held in memory",
                     {"Probes", "spacing", "surfels a probe", "placing, ms", "lighting, ms",
                      "update, ms", "memory, MB"},
                     {}};
    for (const CostPoint& point : sweep.points)
        table.rows.push_back(
            {std::to_string(point.probes), fmt::format("{:.4g}", point.spacing),
             std::to_string(point.per_probe), fmt::format("{:.3g}", point.place_ms),
             fmt::format("{:.3g}", point.light_ms), fmt::format("{:.3g}", point.update_ms),
             fmt::format("{:.4g}", point.bytes / 1e6)});
    const std::string of = sweep.varied == "probes" ? "the number of probes" : "surfels a probe";
    StudyTable laws{"Exponent of the cost in " + of + ", with its 95 % interval",
                    {"Cost", "exponent"},
                    {{"placing surfels", law_text(sweep.place)},
                     {"probe update", law_text(sweep.update)},
                     {"all", law_text(sweep.total)},
                     {"memory", law_text(sweep.bytes)}}};
    StudyChart chart;
    chart.caption = "Cost against " + of + ", both axes logarithmic";
    chart.x_title = of;
    chart.y_title = "milliseconds; megabytes";
    chart.log_x = chart.log_y = true;
    const std::vector<double> x = cost_variable(sweep);
    const auto series = [&](const char* label, const char* color, CostValue value) {
        chart.series.push_back({label, color, x, cost_column(sweep, value), false, true});
    };
    series("placing, ms", "series-0", [](const CostPoint& point) { return point.place_ms; });
    series("lighting, ms", "series-1", [](const CostPoint& point) { return point.light_ms; });
    series("update, ms", "series-2", [](const CostPoint& point) { return point.update_ms; });
    series("memory, MB", "series-3", [](const CostPoint& point) { return point.bytes / 1e6; });
    return {"Against " + of, {}, {laws, table}, {chart}, {}};
}

}  // namespace

ordered_json cost_json(const CostStudy& study, const std::string& scene) {
    return {{"scene", scene},
            {"model", study.model},
            {"repeats", study.repeats},
            {"threads", this_machine().threads},
            {"probes", sweep_json(study.probes)},
            {"surfels", sweep_json(study.surfels)}};
}

StudyPage cost_page(const CostStudy& study, const std::string& scene, const std::string& command) {
    return {"Cost of probes: " + scene,
            command,
            {fmt::format("Model {}, frame 0, every surfel placed and lit, then one probe update. "
                         "Each time is the least of {}. An exponent of 1 says that twice as many "
                         "cost twice as much.",
                         study.model, study.repeats)},
            {sweep_section(study.probes), sweep_section(study.surfels)}};
}

}  // namespace plumbline::reports
