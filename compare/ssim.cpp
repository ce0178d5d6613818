// SPDX-License-Identifier: Apache-2.0
#include "compare/ssim.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "compare/row_sums.h"

namespace plumbline::compare {

namespace {

constexpr double c1 = 0.01 * 0.01;
constexpr double c2 = 0.03 * 0.03;
/// Rec.709 luma [ITU-R BT.709-6, item 3.2].
constexpr std::array<float, 3> luma_weights{0.2126f, 0.7152f, 0.0722f};

/// Luma of the picture as a display with sRGB encoding shows it.
std::vector<float> display_luma(const std::array<std::span<const float>, 3>& layer,
                                const LayerPair& pair) {
    std::vector<float> luma(pair.pixels(), 0.f);
    tbb::parallel_for(0, pair.height, [&](int y) {
        const std::size_t begin = std::size_t(y) * std::size_t(pair.width);
        for (std::size_t i = begin; i < begin + std::size_t(pair.width); ++i) {
            if (!pair.finite[i]) continue;
            for (std::size_t c = 0; c < 3; ++c)
                luma[i] += luma_weights[c] * srgb_from_linear(std::clamp(layer[c][i], 0.f, 1.f));
        }
    });
    return luma;
}

std::array<double, ssim_window> gaussian_weights() {
    std::array<double, ssim_window> weights{};
    double sum = 0;
    constexpr int centre = ssim_window / 2;
    for (int k = 0; k < ssim_window; ++k) {
        const double x = k - centre;
        weights[std::size_t(k)] = std::exp(-x * x / (2 * ssim_sigma * ssim_sigma));
        sum += weights[std::size_t(k)];
    }
    for (double& weight : weights) weight /= sum;
    return weights;
}

/// Weighted sums of r, t, r^2, t^2 and r t.
struct Moments {
    double r = 0, t = 0, rr = 0, tt = 0, rt = 0;

    void add(double weight, const Moments& m) {
        r += weight * m.r;
        t += weight * m.t;
        rr += weight * m.rr;
        tt += weight * m.tt;
        rt += weight * m.rt;
    }
    double similarity() const {
        // Variances are differences of nearly equal numbers: in double precision the rounding
        // that is left is 1e-16, far below C2.
        const double variances = (rr - r * r) + (tt - t * t);
        const double covariance = rt - r * t;
        return (2 * r * t + c1) * (2 * covariance + c2) / ((r * r + t * t + c1) * (variances + c2));
    }
};

}  // namespace

std::optional<double> ssim(const LayerPair& pair) {
    if (pair.width < ssim_window || pair.height < ssim_window) return std::nullopt;
    const std::vector<float> r = display_luma(pair.reference, pair);
    const std::vector<float> t = display_luma(pair.test, pair);
    const auto weights = gaussian_weights();
    const std::size_t width = std::size_t(pair.width);
    const int windows_down = pair.height - ssim_window + 1;
    const std::size_t windows_across = width - ssim_window + 1;

    const auto row_sum = [&](int y) {
        // The window is separable: first down the columns, then along the row.
        std::vector<Moments> columns(width);
        for (std::size_t k = 0; k < ssim_window; ++k) {
            const std::size_t begin = (std::size_t(y) + k) * width;
            for (std::size_t x = 0; x < width; ++x) {
                const double a = double(r[begin + x]);
                const double b = double(t[begin + x]);
                columns[x].add(weights[k], {a, b, a * a, b * b, a * b});
            }
        }
        std::array<double, 2> sums{};  // of similarities, and how many
        const std::size_t middle = (std::size_t(y) + ssim_window / 2) * width + ssim_window / 2;
        for (std::size_t x = 0; x < windows_across; ++x) {
            // A pixel that is not finite counts as black; one outside the mask does not count.
            if (pair.finite[middle + x] && !pair.usable[middle + x]) continue;
            Moments window;
            for (std::size_t k = 0; k < ssim_window; ++k) window.add(weights[k], columns[x + k]);
            sums[0] += window.similarity();
            sums[1] += 1;
        }
        return sums;
    };
    const auto sums = sum_over_rows<2>(windows_down, row_sum);
    if (sums[1] == 0) return std::nullopt;
    return sums[0] / sums[1];
}

}  // namespace plumbline::compare
