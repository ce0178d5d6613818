// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <cmath>

#include "reports/frontier_page.h"
#include "reports/frontier_sentences.h"
#include "reports/machine.h"

namespace plumbline::reports {

namespace {

using nlohmann::ordered_json;

ordered_json json_of(const Spread& spread) {
    return {{"median", spread.median}, {"least", spread.least}, {"most", spread.most}};
}

ordered_json json_of(const std::optional<Spread>& spread) {
    return spread ? json_of(*spread) : ordered_json(nullptr);
}

ordered_json json_of(const FrontierPoint& point) {
    return {{"method", point.method},
            {"setting", point.setting},
            {"options", point.options},
            {"error", json_of(point.error)},
            {"mse", point.mse},
            {"noise_mse", point.noise_mse},
            {"bias_mse", point.bias_mse},
            {"bias_mse_ci95", point.bias_mse_ci95},
            {"seconds", json_of(point.seconds)},
            {"frame_seconds", json_of(point.frame_seconds)},
            {"place_ms", json_of(point.place_ms)},
            {"update_ms", json_of(point.update_ms)},
            {"primary_ms", json_of(point.primary_ms)},
            {"bytes", point.bytes},
            {"updates", point.updates},
            {"non_finite", point.non_finite}};
}

ordered_json json_of(const TimedError& point) {
    return {{"method", point.method},
            {"setting", point.setting},
            {"seconds", point.seconds},
            {"error", point.error}};
}

ordered_json json_of(const Reign& reign) {
    const bool ends = std::isfinite(reign.until_seconds);
    return {{"method", reign.method},
            {"from_seconds", reign.from_seconds},
            {"until_seconds", ends ? ordered_json(reign.until_seconds) : ordered_json(nullptr)},
            {"error_from", reign.error_from},
            {"error_until", reign.error_until}};
}

ordered_json json_of(const std::optional<ErrorLaw>& law) {
    if (!law) return nullptr;
    return {{"exponent", law->law.exponent},
            {"exponent_ci95", law->law.exponent_ci95},
            {"scale", law->law.scale},
            {"least_seconds", law->least_seconds},
            {"most_seconds", law->most_seconds}};
}

ordered_json budget_json(const std::vector<TimedError>& points) {
    const std::optional<ErrorLaw> law = fit_error_law(points, path_tracer_method);
    ordered_json pareto = ordered_json::array();
    ordered_json floors = ordered_json::array();
    ordered_json best = ordered_json::array();
    for (const std::size_t i : pareto_set(points)) pareto.push_back(json_of(points[i]));
    for (const ErrorFloor& floor : error_floors(points)) {
        ordered_json one = json_of(floor.floor);
        one["tenth_above"] = json_of(floor.tenth_above);
        one["path_tracer_seconds"] =
            law ? ordered_json(law->seconds_to(floor.floor.error)) : ordered_json(nullptr);
        floors.push_back(one);
    }
    for (const Reign& reign : best_by_budget(points, law)) best.push_back(json_of(reign));
    return {{"path_tracer_law", json_of(law)},
            {"pareto", pareto},
            {"floors", floors},
            {"best_by_budget", best}};
}

}  // namespace

ordered_json frontier_json(const Frontier& frontier) {
    ordered_json points = ordered_json::array();
    for (const FrontierPoint& point : frontier.points) points.push_back(json_of(point));
    return {{"scene", frontier.scene},
            {"frame", frontier.frame},
            {"width", frontier.width},
            {"height", frontier.height},
            {"repeats", frontier.repeats},
            {"threads", this_machine().threads},
            {"truth_noise", frontier.truth_noise},
            {"points", points},
            {"still", budget_json(timed_errors(frontier, Budget::Still))},
            {"frame_budget", budget_json(timed_errors(frontier, Budget::Frame))},
            {"sentences", frontier_sentences(frontier)}};
}

std::string frontier_csv(const Frontier& frontier) {
    std::string csv =
        "method,setting,options,error_median,error_least,error_most,mse,noise_mse,bias_mse,"
        "bias_mse_low,bias_mse_high,seconds_median,seconds_least,seconds_most,"
        "frame_seconds_median,place_ms,update_ms,primary_ms,bytes,updates,non_finite\n";
    for (const FrontierPoint& point : frontier.points) {
        const std::string error = point.error ? fmt::format("{},{},{}", point.error->median,
                                                            point.error->least, point.error->most)
                                              : ",,";
        const std::string frame =
            point.frame_seconds ? fmt::format("{}", point.frame_seconds->median) : "";
        csv += fmt::format(
            "\"{}\",\"{}\",\"{}\",{},{},{},{},{},{},{},{},{},{},{},{},{},{:.0f},{},{}\n",
            point.method, point.setting, point.options, error, point.mse, point.noise_mse,
            point.bias_mse, point.bias_mse_ci95[0], point.bias_mse_ci95[1], point.seconds.median,
            point.seconds.least, point.seconds.most, frame, point.place_ms.median,
            point.update_ms.median, point.primary_ms.median, point.bytes, point.updates,
            point.non_finite);
    }
    return csv;
}

}  // namespace plumbline::reports
