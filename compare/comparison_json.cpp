// SPDX-License-Identifier: Apache-2.0
#include "compare/comparison_json.h"

namespace plumbline::compare {

namespace {

using nlohmann::ordered_json;

ordered_json number(const std::optional<double>& value) {
    return value ? ordered_json(*value) : ordered_json(nullptr);
}

ordered_json scales_json(const std::vector<ScaleError>& scales) {
    ordered_json curve = ordered_json::array();
    for (const ScaleError& error : scales)
        curve.push_back(
            {{"width", error.width}, {"rmse", error.rmse}, {"if_noise", error.if_noise}});
    return {{"slope", number(scale_slope(scales))},
            {"verdict", scale_verdict(scales)},
            {"curve", curve}};
}

ordered_json flip_json(const Comparison& comparison) {
    if (!comparison.flip) return nullptr;
    const FlipResult& flip = *comparison.flip;
    if (comparison.flip_variant == FlipVariant::Ldr)
        return {{"variant", "LDR"}, {"pixels_per_degree", comparison.pixels_per_degree}};
    return {{"variant", "HDR"},
            {"pixels_per_degree", comparison.pixels_per_degree},
            {"tone_mapper", tone_curve(comparison.tone_mapper).name},
            {"start_exposure", flip.start_exposure},
            {"stop_exposure", flip.stop_exposure},
            {"exposures", flip.exposures}};
}

/// Those that are defined for any part of a picture.
ordered_json part_metrics(const Metrics& metrics) {
    ordered_json json = metrics_json(metrics);
    json.erase("ssim");
    if (!metrics.flip) json.erase("flip");
    return json;
}

ordered_json channels_json(const Comparison& comparison) {
    ordered_json json = ordered_json::array();
    for (std::size_t c = 0; c < comparison.channels.size(); ++c) {
        json.push_back({{"channel", comparison.channels[c]}});
        json.back().update(part_metrics(comparison.channel_metrics[c]));
    }
    return json;
}

ordered_json objects_json(const std::vector<ObjectError>& objects) {
    ordered_json json = ordered_json::array();
    for (const ObjectError& error : objects) {
        json.push_back({{"object", error.object},
                        {"pixels", error.pixels},
                        {"share_of_squared_error", error.share}});
        json.back().update(part_metrics(error.metrics));
    }
    return json;
}

ordered_json percentiles_json(const std::vector<ErrorPercentile>& percentiles) {
    ordered_json json = ordered_json::array();
    for (const ErrorPercentile& one : percentiles)
        json.push_back({{"percent", one.percent},
                        {"error", one.error},
                        {"share_of_squared_error_above", one.share_above}});
    return json;
}

}  // namespace

ordered_json noise_json(const std::optional<NoiseSplit>& noise) {
    if (!noise) return nullptr;
    return {{"method", noise->method},
            {"mse_expected_from_noise", noise->mse_expected_from_noise},
            {"mse_overstated", noise->mse_overstated},
            {"bias_mse", noise->bias_mse},
            {"bias_mse_ci95", noise->bias_mse_ci95},
            {"z_fraction_above_3", noise->z_fraction_above_3},
            {"channel_correlation", noise->channel_correlation},
            {"shared_samples", noise->shared_samples},
            {"reference_variance", noise->reference_variance},
            {"test_variance", noise->test_variance},
            {"left_out", noise->left_out}};
}

ordered_json metrics_json(const Metrics& metrics) {
    ordered_json json;
    for (const MetricDescription& metric : metric_descriptions())
        json[metric.name] = number(metric.value(metrics));
    return json;
}

ordered_json to_json(const Comparison& comparison) {
    ordered_json first = nullptr;
    if (comparison.first_non_finite)
        first = {comparison.first_non_finite->x, comparison.first_non_finite->y};
    ordered_json noise_unknown = nullptr;
    if (!comparison.noise) noise_unknown = comparison.noise_unknown;
    return {{"metrics", metrics_json(comparison.metrics)},
            {"noise", noise_json(comparison.noise)},
            {"noise_unknown", noise_unknown},
            {"non_finite", comparison.non_finite},
            {"pixels", comparison.pixels},
            {"layer", comparison.layer},
            {"first_non_finite", first},
            {"flip", flip_json(comparison)},
            {"error_by_scale", scales_json(comparison.scales)},
            {"counted_pixels", comparison.counted_pixels},
            {"channels", channels_json(comparison)},
            {"objects", objects_json(comparison.objects)},
            {"percentiles", percentiles_json(comparison.percentiles)}};
}

}  // namespace plumbline::compare
