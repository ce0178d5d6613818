// SPDX-License-Identifier: Apache-2.0
#include "compare/metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "compare/row_sums.h"

namespace plumbline::compare {

namespace {

struct ChannelSums {
    std::array<ErrorSums, 3> channels;
    void add(const ChannelSums& other) {
        for (std::size_t c = 0; c < 3; ++c) channels[c].add(other.channels[c]);
    }
};

}  // namespace

void ErrorSums::add(double r, double t) {
    const double d = t - r;
    values += 1;
    signed_error += d;
    absolute += std::abs(d);
    square += d * d;
    relative += d * d / (r * r + relmse_epsilon);
    symmetric += std::abs(d) / (std::abs(r) + std::abs(t) + smape_epsilon);
    peak = std::max(peak, r);
}

void ErrorSums::add(const ErrorSums& other) {
    values += other.values;
    signed_error += other.signed_error;
    absolute += other.absolute;
    square += other.square;
    relative += other.relative;
    symmetric += other.symmetric;
    peak = std::max(peak, other.peak);
}

Metrics ErrorSums::metrics() const {
    const double mse = square / values;
    Metrics metrics;
    metrics.bias = signed_error / values;
    metrics.mae = absolute / values;
    metrics.rmse = std::sqrt(mse);
    metrics.relmse = relative / values;
    metrics.smape = symmetric / values;
    // Equal black pictures would divide zero by zero.
    metrics.psnr_db =
        mse == 0.0 ? std::numeric_limits<double>::infinity() : 10.0 * std::log10(peak * peak / mse);
    return metrics;
}

std::array<ErrorSums, 3> channel_errors(const LayerPair& pair) {
    const auto row_sums = [&](int y) {
        ChannelSums row;
        const std::size_t begin = std::size_t(y) * std::size_t(pair.width);
        for (std::size_t i = begin; i < begin + std::size_t(pair.width); ++i) {
            if (!pair.usable[i]) continue;
            for (std::size_t c = 0; c < 3; ++c)
                row.channels[c].add(double(pair.reference[c][i]), double(pair.test[c][i]));
        }
        return row;
    };
    return merge_rows<ChannelSums>(pair.height, row_sums).channels;
}

Metrics pixel_metrics(const LayerPair& pair) {
    auto [sums, g, b] = channel_errors(pair);
    sums.add(g);
    sums.add(b);
    return sums.metrics();
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
        {"flip", "mean FLIP (HDR for float, LDR for 8-bit)",
         [](const Metrics& m) { return m.flip; }},
    };
    return descriptions;
}

}  // namespace plumbline::compare
