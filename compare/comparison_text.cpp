// SPDX-License-Identifier: Apache-2.0
#include "compare/comparison_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline::compare {

namespace {

std::string shown(const std::optional<double>& value) {
    return value ? fmt::format("{:.6g}", *value) : "undefined";
}

std::string noise_text(const Comparison& comparison) {
    const std::optional<NoiseSplit>& noise = comparison.noise;
    if (!noise) return "noise    unknown: " + comparison.noise_unknown + "\n";
    std::string text = fmt::format(
        "noise    {:.6g} of the MSE is expected from noise\n"
        "bias     {:.6g} of the MSE is not noise (95 % interval {:.6g} to {:.6g})\n"
        "z > 3    {:.3f} % of values (if all is noise: 0.27 %, some percent from few batches)\n",
        noise->mse_expected_from_noise, noise->bias_mse, noise->bias_mse_ci95[0],
        noise->bias_mse_ci95[1], 100 * noise->z_fraction_above_3);
    text += "         by " + noise->method + "\n";
    if (noise->shared_samples)
        text +=
            "         both are of one seed, the samples of one among the other's: variances are "
            "subtracted\n";
    if (!noise->reference_variance)
        text += "         nothing tells the reference's noise: taken as exact\n";
    if (!noise->test_variance) text += "         nothing tells the test's noise: taken as exact\n";
    if (noise->mse_overstated > 0)
        text += fmt::format(
            "         {:.6g} of the noise is of fewer than 32 samples, which overstate it: the "
            "interval allows for bias in its place\n",
            noise->mse_overstated);
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
    return text + scale_verdict(scales) + "\n";
}

std::string exposures_text(const Comparison& comparison) {
    if (comparison.flip_variant == FlipVariant::Ldr) return "";
    return fmt::format(", {}, {} exposures from {:.4f} to {:.4f} stops",
                       tone_curve(comparison.tone_mapper).name, comparison.flip->exposures,
                       comparison.flip->start_exposure, comparison.flip->stop_exposure);
}

constexpr std::size_t most_objects_shown = 12;

std::string part_line(const std::string& name, const Metrics& m) {
    return fmt::format("{:<12} {:>11.4g} {:>11.4g} {:>11.4g} {:>11.4g}", name, m.bias, m.mae,
                       m.rmse, m.relmse);
}

std::string parts_text(const Comparison& comparison) {
    std::string text = fmt::format("\n{:<12} {:>11} {:>11} {:>11} {:>11}\n", "channel", "bias",
                                   "mae", "rmse", "relmse");
    for (std::size_t c = 0; c < comparison.channels.size(); ++c)
        text += part_line(comparison.channels[c], comparison.channel_metrics[c]) + "\n";
    if (comparison.objects.empty()) return text;
    text += fmt::format("{:<60} {:>10}  {}\n", "object", "pixels", "of the squared error");
    for (std::size_t k = 0; k < std::min(most_objects_shown, comparison.objects.size()); ++k) {
        const ObjectError& object = comparison.objects[k];
        text += fmt::format("{} {:>10}  {:.1f} %\n",
                            part_line(fmt::format("{}", object.object), object.metrics),
                            object.pixels, 100 * object.share);
    }
    if (comparison.objects.size() > most_objects_shown)
        text += fmt::format("and {} more, in the JSON\n",
                            comparison.objects.size() - most_objects_shown);
    return text;
}

std::string percentiles_text(const std::vector<ErrorPercentile>& percentiles) {
    std::string text = "\n% of pixels   error at most   of the squared error above\n";
    for (const ErrorPercentile& one : percentiles)
        text += fmt::format("{:>11}   {:>13.6g}   {:>24.1f} %\n", one.percent, one.error,
                            100 * one.share_above);
    return text;
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
    if (comparison.counted_pixels < comparison.pixels)
        text += fmt::format("of {} of {} pixels\n", comparison.counted_pixels, comparison.pixels);
    return text + "\n" + noise_text(comparison) + scales_text(comparison.scales) +
           parts_text(comparison) + percentiles_text(comparison.percentiles);
}

}  // namespace plumbline::compare
