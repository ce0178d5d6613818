// SPDX-License-Identifier: Apache-2.0
#include "compare/comparison_text.h"

#include <fmt/format.h>

namespace plumbline::compare {

namespace {

std::string shown(const std::optional<double>& value) {
    return value ? fmt::format("{:.6g}", *value) : "undefined";
}

std::string noise_text(const std::optional<NoiseSplit>& noise) {
    if (!noise) return "noise    unknown: neither image has a variance layer\n";
    std::string text = fmt::format(
        "noise    {:.6g} of the MSE is expected from noise\n"
        "bias     {:.6g} of the MSE is not noise (95 % interval {:.6g} to {:.6g})\n"
        "z > 3    {:.3f} % of values (0.27 % if all is noise)\n",
        noise->mse_expected_from_noise, noise->bias_mse, noise->bias_mse_ci95[0],
        noise->bias_mse_ci95[1], 100 * noise->z_fraction_above_3);
    if (!noise->reference_variance)
        text += "         the reference has no variances: taken as exact\n";
    if (!noise->test_variance) text += "         the test has no variances: taken as exact\n";
    if (noise->left_out > 0)
        text += fmt::format("         {} pixels left out: variance negative or not finite\n",
                            noise->left_out);
    return text;
}

std::string scales_text(const std::vector<ScaleError>& scales) {
    std::string text = "\nblock width   rmse of means   if all were noise\n";
    for (const ScaleError& error : scales)
        text += fmt::format("{:>11}   {:>13.6g}   {:>17.6g}\n", error.width, error.rmse,
                            error.if_noise);
    if (const auto slope = scale_slope(scales))
        text += fmt::format("slope {:.2f} per doubling (-1: noise, 0: bias)\n", *slope);
    return text;
}

std::string exposures_text(const Comparison& comparison) {
    if (comparison.flip_variant == FlipVariant::Ldr) return "";
    return fmt::format(", {} exposures from {:.4f} to {:.4f} stops", comparison.flip->exposures,
                       comparison.flip->start_exposure, comparison.flip->stop_exposure);
}

}  // namespace

std::string to_text(const Comparison& comparison) {
    std::string text;
    for (const MetricDescription& metric : metric_descriptions())
        text += fmt::format("{:<8} {:<13} {}\n", metric.name,
                            shown(metric.value(comparison.metrics)), metric.formula);
    if (comparison.flip)
        text += fmt::format("{:<22} at {:.4g} pixels per degree{}\n", "",
                            comparison.pixels_per_degree, exposures_text(comparison));
    return text + "\n" + noise_text(comparison.noise) + scales_text(comparison.scales);
}

}  // namespace plumbline::compare
