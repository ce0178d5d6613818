// SPDX-License-Identifier: Apache-2.0
#include "compare/metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "compare/row_sums.h"

namespace plumbline::compare {

namespace {

enum Sum : std::size_t { Signed, Absolute, Square, Relative, Symmetric, SumCount };

/// The largest finite reference value: what PSNR calls the peak.
double peak_of(const LayerPair& pair) {
    float peak = 0.f;
    for (std::size_t i = 0; i < pair.pixels(); ++i)
        if (pair.usable[i])
            for (const auto& channel : pair.reference) peak = std::max(peak, channel[i]);
    return double(peak);
}

std::array<double, SumCount> row_errors(const LayerPair& pair, int y) {
    std::array<double, SumCount> sums{};
    const std::size_t begin = std::size_t(y) * std::size_t(pair.width);
    for (std::size_t i = begin; i < begin + std::size_t(pair.width); ++i) {
        if (!pair.usable[i]) continue;
        for (std::size_t c = 0; c < 3; ++c) {
            const double r = double(pair.reference[c][i]);
            const double t = double(pair.test[c][i]);
            const double d = t - r;
            sums[Signed] += d;
            sums[Absolute] += std::abs(d);
            sums[Square] += d * d;
            sums[Relative] += d * d / (r * r + relmse_epsilon);
            sums[Symmetric] += std::abs(d) / (std::abs(r) + std::abs(t) + smape_epsilon);
        }
    }
    return sums;
}

}  // namespace

Metrics pixel_metrics(const LayerPair& pair) {
    const auto sums =
        sum_over_rows<SumCount>(pair.height, [&](int y) { return row_errors(pair, y); });
    const double n = 3.0 * double(pair.usable_pixels);
    const double mse = sums[Square] / n;
    Metrics metrics;
    metrics.bias = sums[Signed] / n;
    metrics.mae = sums[Absolute] / n;
    metrics.rmse = std::sqrt(mse);
    metrics.relmse = sums[Relative] / n;
    metrics.smape = sums[Symmetric] / n;
    const double peak = peak_of(pair);
    // Equal black pictures would divide zero by zero.
    metrics.psnr_db =
        mse == 0.0 ? std::numeric_limits<double>::infinity() : 10.0 * std::log10(peak * peak / mse);
    return metrics;
}

const std::vector<MetricDescription>& metric_descriptions() {
    using Value = std::optional<double>;
    static const std::vector<MetricDescription> descriptions{
        {"bias", "mean(t - r)", [](const Metrics& m) { return Value(m.bias); }},
        {"mae", "mean |t - r|", [](const Metrics& m) { return Value(m.mae); }},
        {"rmse", "sqrt(mean (t - r)^2)", [](const Metrics& m) { return Value(m.rmse); }},
        {"relmse", "mean (t - r)^2 / (r^2 + 0.01)",
         [](const Metrics& m) { return Value(m.relmse); }},
        {"smape", "mean |t - r| / (|r| + |t| + 0.01)",
         [](const Metrics& m) { return Value(m.smape); }},
        {"psnr_db", "10 log10(max(r)^2 / mean (t - r)^2)",
         [](const Metrics& m) { return Value(m.psnr_db); }},
        {"ssim", "mean SSIM of sRGB luma clamped to [0,1], 11x11 Gaussian, sigma 1.5",
         [](const Metrics& m) { return m.ssim; }},
        {"flip", "mean FLIP (HDR with ACES for float, LDR for 8-bit)",
         [](const Metrics& m) { return m.flip; }},
    };
    return descriptions;
}

}  // namespace plumbline::compare
