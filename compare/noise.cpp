// SPDX-License-Identifier: Apache-2.0
#include "compare/noise.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "compare/find_layer.h"
#include "compare/row_sums.h"
#include "compare/shared_samples.h"

namespace plumbline::compare {

namespace {

using Layer = std::array<std::span<const float>, 3>;

/// d and s^2 of a pixel's channels.
struct Errors {
    std::array<double, 3> d;
    std::array<double, 3> variance;  ///< absolute, as single pixels of a difference may be below 0
    double noise = 0;                ///< sum of the variances, test's less reference's if shared
    double overstated = 0;  ///< of the variances' sum, what comes from those that overstate
};

/// Where a pair's errors and variances are looked up.
struct NoisyPair {
    const LayerPair& pair;
    std::optional<Layer> reference_variance, test_variance;
    bool reference_overstates, test_overstates;
    bool shared;  ///< one picture's samples are among the other's

    Errors at(std::size_t i) const {
        Errors errors;
        for (std::size_t c = 0; c < 3; ++c) {
            errors.d[c] = double(pair.test[c][i]) - double(pair.reference[c][i]);
            const double r = reference_variance ? double((*reference_variance)[c][i]) : 0.0;
            const double t = test_variance ? double((*test_variance)[c][i]) : 0.0;
            // Of means t over n samples and r over these and more, Cov(t, r) = Var(r).
            errors.noise += shared ? t - r : t + r;
            errors.variance[c] = shared ? std::abs(t - r) : t + r;
            errors.overstated += (reference_overstates ? r : 0.0) + (test_overstates ? t : 0.0);
        }
        return errors;
    }
    bool usable(std::size_t i) const {
        if (!pair.usable[i]) return false;
        for (const auto& layer : {reference_variance, test_variance})
            for (std::size_t c = 0; layer && c < 3; ++c)
                if (!(std::isfinite((*layer)[c][i]) && (*layer)[c][i] >= 0.f)) return false;
        return true;
    }
};

double sign(double x) { return double(x > 0) - double(x < 0); }

enum Sum : std::size_t { Square, Noise, Overstated, Above, Plugged, NoiseOnly, Pixels, SumCount };

void add_pixel(const Errors& e, const std::array<double, 3>& rho,
               std::array<double, SumCount>& sums) {
    for (std::size_t c = 0; c < 3; ++c) {
        const double d2 = e.d[c] * e.d[c], s2 = e.variance[c];
        sums[Square] += d2;
        // Without noise any difference is infinitely many deviations away; none is zero of them.
        sums[Above] += double(d2 > z_threshold * z_threshold * s2);
        sums[Plugged] += 4 * s2 * d2 - 2 * s2 * s2;
        sums[NoiseOnly] += 2 * s2 * s2;
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const auto [a, b] = channel_pairs[k];
        const double cov = rho[k] * std::sqrt(e.variance[a] * e.variance[b]);
        // Both orders of a pair of channels stand in the variance of a sum.
        sums[Plugged] += 2 * (4 * cov * e.d[a] * e.d[b] - 2 * cov * cov);
        sums[NoiseOnly] += 2 * (2 * cov * cov);
    }
    sums[Noise] += e.noise;
    sums[Overstated] += e.overstated;
    sums[Pixels] += 1;
}

}  // namespace

std::string variance_layer(const std::string& layer) {
    return layer.empty() ? "variance" : "variance_" + layer;
}

std::optional<Layer> variances_of(const Image& image, const std::string& layer) {
    const auto found = find_layer_if_there(image, variance_layer(layer));
    if (!found) return std::nullopt;
    return found->channels;
}

std::array<double, 3> channel_correlations(const LayerPair& pair) {
    const std::size_t width = std::size_t(pair.width);
    const auto sums = sum_over_rows<6>(pair.height, [&](int y) {
        std::array<double, 6> row{};
        const std::size_t begin = std::size_t(y) * width;
        for (std::size_t i = begin; i + 1 < begin + width; i += 2) {
            if (!pair.usable[i] || !pair.usable[i + 1]) continue;
            std::array<double, 3> step;  // of d, to the next pixel
            for (std::size_t c = 0; c < 3; ++c)
                step[c] = sign((double(pair.test[c][i]) - double(pair.reference[c][i])) -
                               (double(pair.test[c][i + 1]) - double(pair.reference[c][i + 1])));
            for (std::size_t k = 0; k < 3; ++k) {
                const double product = step[channel_pairs[k][0]] * step[channel_pairs[k][1]];
                row[2 * k] += product;
                row[2 * k + 1] += std::abs(product);
            }
        }
        return row;
    });
    std::array<double, 3> rho;
    for (std::size_t k = 0; k < 3; ++k) {
        // With no pair of neighbours to tell, the widest interval is the honest one.
        const double quadrant = sums[2 * k + 1] > 0 ? sums[2 * k] / sums[2 * k + 1] : 1.0;
        rho[k] = std::max(0.0, std::sin(0.5 * std::numbers::pi * quadrant));
    }
    return rho;
}

std::optional<NoiseSplit> split_noise(const Image& reference, const Image& test,
                                      const LayerPair& pair) {
    const NoisyPair noisy{pair,
                          variances_of(reference, pair.layer),
                          variances_of(test, pair.layer),
                          variances_overstate(reference),
                          variances_overstate(test),
                          share_samples(reference, test)};
    if (!noisy.reference_variance && !noisy.test_variance) return std::nullopt;

    const std::array<double, 3> rho = channel_correlations(pair);
    const auto sums = sum_over_rows<SumCount>(pair.height, [&](int y) {
        std::array<double, SumCount> row{};
        const std::size_t begin = std::size_t(y) * std::size_t(pair.width);
        for (std::size_t i = begin; i < begin + std::size_t(pair.width); ++i)
            if (noisy.usable(i)) add_pixel(noisy.at(i), rho, row);
        return row;
    });
    if (sums[Pixels] == 0) return std::nullopt;

    const double n = 3 * sums[Pixels];
    NoiseSplit split;
    const double noise = noisy.shared ? std::abs(sums[Noise]) : sums[Noise];
    split.shared_samples = noisy.shared;
    split.mse_expected_from_noise = noise / n;
    split.bias_mse = (sums[Square] - noise) / n;
    split.mse_overstated = sums[Overstated] / n;
    const double half_width = z_95 * std::sqrt(std::max(sums[Plugged], sums[NoiseOnly])) / n;
    split.bias_mse_ci95 = {split.bias_mse - half_width,
                           split.bias_mse + split.mse_overstated + half_width};
    split.z_fraction_above_3 = sums[Above] / n;
    split.channel_correlation = (rho[0] + rho[1] + rho[2]) / 3;
    split.reference_variance = noisy.reference_variance.has_value();
    split.test_variance = noisy.test_variance.has_value();
    split.left_out = pair.usable_pixels - std::size_t(sums[Pixels]);
    return split;
}

}  // namespace plumbline::compare
