// SPDX-License-Identifier: Apache-2.0
#include "compare/scales.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/row_sums.h"

namespace plumbline::compare {

namespace {

constexpr int widest_block = 64;
constexpr std::size_t fewest_blocks = 8;  ///< that a verdict rests on

enum Sum : std::size_t { SquaredMean, IfNoise, Channels, SumCount };

/// Sums over the row of blocks that starts at row `top`.
std::array<double, SumCount> block_row(const LayerPair& pair, int top, int width) {
    std::array<double, SumCount> sums{};
    for (int left = 0; left + width <= pair.width; left += width) {
        std::array<double, 3> d{};
        double squares = 0, pixels = 0;
        for (int y = top; y < top + width; ++y)
            for (int x = left; x < left + width; ++x) {
                const std::size_t i = std::size_t(y) * std::size_t(pair.width) + std::size_t(x);
                if (!pair.usable[i]) continue;
                for (std::size_t c = 0; c < 3; ++c) {
                    const double error = double(pair.test[c][i]) - double(pair.reference[c][i]);
                    d[c] += error;
                    squares += error * error;
                }
                pixels += 1;
            }
        if (pixels == 0) continue;
        for (double sum : d) sums[SquaredMean] += (sum / pixels) * (sum / pixels);
        sums[IfNoise] += squares / (pixels * pixels);
        sums[Channels] += 3;
    }
    return sums;
}

}  // namespace

std::vector<ScaleError> error_by_scale(const LayerPair& pair) {
    std::vector<ScaleError> errors;
    for (int width = 1; width <= std::min({widest_block, pair.width, pair.height}); width *= 2) {
        const auto sums = sum_over_rows<SumCount>(
            pair.height / width, [&](int row) { return block_row(pair, row * width, width); });
        const double n = sums[Channels];
        if (n == 0) break;
        errors.push_back({width, std::sqrt(sums[SquaredMean] / n), std::sqrt(sums[IfNoise] / n),
                          static_cast<std::size_t>(n / 3)});
    }
    return errors;
}

std::optional<double> scale_slope(const std::vector<ScaleError>& errors) {
    const bool has_zero =
        std::any_of(errors.begin(), errors.end(), [](const ScaleError& e) { return e.rmse <= 0; });
    if (errors.size() < 2 || has_zero) return std::nullopt;
    const double n = double(errors.size());
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (const ScaleError& error : errors) {
        const double x = std::log2(error.width), y = std::log2(error.rmse);
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

std::string scale_verdict(const std::vector<ScaleError>& errors) {
    const auto judged = std::find_if(errors.rbegin(), errors.rend(), [](const ScaleError& error) {
        return error.blocks >= fewest_blocks;
    });
    if (judged == errors.rend() || judged->width == 1) return "too few pixels to tell";
    if (errors.front().rmse == 0) return "no error";
    const double ratio = judged->rmse / judged->if_noise;
    const double three_standard_errors = 3 / std::sqrt(2. * double(judged->blocks));
    const std::string figure =
        fmt::format("{:.3g} times what noise leaves at width {}", ratio, judged->width);
    if (ratio > 1 + three_standard_errors) return "structure or bias: " + figure;
    if (ratio < 1 - three_standard_errors) return "errors that cancel: " + figure;
    return "noise: " + figure;
}

}  // namespace plumbline::compare
