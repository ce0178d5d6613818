// SPDX-License-Identifier: Apache-2.0
#include "compare/halves.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compare/row_sums.h"
#include "compare/shared_samples.h"
#include "scenes/errors.h"

namespace plumbline::compare {

namespace {

constexpr int window_radius = 4;

using Layer = std::array<std::span<const float>, 3>;

/// The pair and its second pictures.
struct HalvedPair {
    const LayerPair& pair;
    LayerPair second;
    std::vector<Layer> shared;      ///< variances of noise that both pictures share
    std::vector<Layer> overstated;  ///< those of them that overstate

    bool usable(std::size_t i) const {
        if (!pair.usable[i] || !second.finite[i]) return false;
        for (const Layer& layer : shared)
            for (const auto& channel : layer)
                if (!(std::isfinite(channel[i]) && channel[i] >= 0.f)) return false;
        return true;
    }
    double d1(std::size_t c, std::size_t i) const {
        return double(pair.test[c][i]) - double(pair.reference[c][i]);
    }
    double d2(std::size_t c, std::size_t i) const {
        return double(second.test[c][i]) - double(second.reference[c][i]);
    }
    double shared_variance(std::size_t c, std::size_t i) const { return sum_of(shared, c, i); }
    double overstated_variance(std::size_t c, std::size_t i) const {
        return sum_of(overstated, c, i);
    }
    /// s^2 of d1, from this pixel alone.
    double variance(std::size_t c, std::size_t i) const {
        const double v = d1(c, i) - d2(c, i);
        return 0.5 * v * v + shared_variance(c, i);
    }

 private:
    static double sum_of(const std::vector<Layer>& layers, std::size_t c, std::size_t i) {
        double sum = 0;
        for (const Layer& layer : layers) sum += double(layer[c][i]);
        return sum;
    }
};

enum Sum : std::size_t { Product, Noise, Overstated, Plugged, Pixels, SumCount };

void add_pixel(const HalvedPair& halved, const std::array<double, 3>& rho, std::size_t i,
               std::array<double, SumCount>& sums) {
    std::array<double, 3> d1, d2, s2;
    double uv = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        d1[c] = halved.d1(c, i);
        d2[c] = halved.d2(c, i);
        s2[c] = halved.shared_variance(c, i);
        sums[Product] += d1[c] * d2[c] - s2[c];
        sums[Noise] += halved.variance(c, i);
        sums[Overstated] += halved.overstated_variance(c, i);
        uv += 0.5 * (d1[c] + d2[c]) * (d1[c] - d2[c]);
        sums[Plugged] += 4 * s2[c] * d1[c] * d2[c] - 2 * s2[c] * s2[c];
    }
    sums[Plugged] += uv * uv;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto [a, b] = channel_pairs[k];
        const double cov = rho[k] * std::sqrt(s2[a] * s2[b]);
        // Both orders of a pair of channels stand in the variance of a sum.
        sums[Plugged] += 4 * cov * (d1[a] * d2[b] + d2[a] * d1[b]) - 4 * cov * cov;
    }
    sums[Pixels] += 1;
}

/// A sum over part of a window, and of how many values.
struct Window {
    double sum = 0, count = 0;
    void add(const Window& other) {
        sum += other.sum;
        count += other.count;
    }
};

/// The mean of a channel's variance over the window around each pixel.
std::vector<float> local_variance(const HalvedPair& halved, std::size_t c) {
    const int width = halved.pair.width, height = halved.pair.height;
    std::vector<Window> across(halved.pair.pixels());
    tbb::parallel_for(0, height, [&](int y) {
        const std::size_t begin = std::size_t(y) * std::size_t(width);
        for (int x = 0; x < width; ++x)
            for (int k = std::max(0, x - window_radius);
                 k <= std::min(width - 1, x + window_radius); ++k)
                if (const std::size_t i = begin + std::size_t(k); halved.usable(i))
                    across[begin + std::size_t(x)].add({halved.variance(c, i), 1});
    });
    std::vector<float> means(halved.pair.pixels(), 0.f);
    tbb::parallel_for(0, height, [&](int y) {
        for (int x = 0; x < width; ++x) {
            Window window;
            for (int k = std::max(0, y - window_radius);
                 k <= std::min(height - 1, y + window_radius); ++k)
                window.add(across[std::size_t(k) * std::size_t(width) + std::size_t(x)]);
            if (window.count > 0)
                means[std::size_t(y) * std::size_t(width) + std::size_t(x)] =
                    float(window.sum / window.count);
        }
    });
    return means;
}

double above_threshold(const HalvedPair& halved, const std::array<std::vector<float>, 3>& s2) {
    return sum_over_rows<1>(halved.pair.height, [&](int y) {
        std::array<double, 1> row{};
        const std::size_t begin = std::size_t(y) * std::size_t(halved.pair.width);
        for (std::size_t i = begin; i < begin + std::size_t(halved.pair.width); ++i)
            for (std::size_t c = 0; c < 3 && halved.usable(i); ++c) {
                const double d = halved.d1(c, i);
                row[0] += double(d * d > z_threshold * z_threshold * double(s2[c][i]));
            }
        return row;
    })[0];
}

}  // namespace

HalvesSplit split_by_halves(const Image& reference, const Image& test, const Halves& halves,
                            const LayerPair& pair) {
    assert(halves.reference || halves.test);
    check_independent(reference, test, halves);
    HalvedPair halved{pair,
                      pair_layers(halves.reference ? *halves.reference : reference,
                                  halves.test ? *halves.test : test, pair.layer),
                      {},
                      {}};
    const bool fits = halved.second.width == pair.width && halved.second.height == pair.height;
    if (halves.reference && !fits)
        pair_layers(reference, *halves.reference, pair.layer);  // throws with the sizes
    const auto share = [&](const Image& image, const std::optional<Layer>& variance) {
        if (!variance) return;
        halved.shared.push_back(*variance);
        if (variances_overstate(image)) halved.overstated.push_back(*variance);
    };
    const auto reference_variance = variances_of(reference, pair.layer);
    const auto test_variance = variances_of(test, pair.layer);
    if (!halves.reference) share(reference, reference_variance);
    if (!halves.test) share(test, test_variance);

    const auto rho = channel_correlations(pair);
    const auto sums = sum_over_rows<SumCount>(pair.height, [&](int y) {
        std::array<double, SumCount> row{};
        const std::size_t begin = std::size_t(y) * std::size_t(pair.width);
        for (std::size_t i = begin; i < begin + std::size_t(pair.width); ++i)
            if (halved.usable(i)) add_pixel(halved, rho, i, row);
        return row;
    });

    if (sums[Pixels] == 0)
        throw ImageError((halves.test ? *halves.test : *halves.reference).source,
                         "no pixel is finite in both halves",
                         "halves are two renders of the same picture");
    HalvesSplit result;
    for (std::size_t c = 0; c < 3; ++c) result.variance[c] = local_variance(halved, c);
    const double n = 3 * sums[Pixels];
    NoiseSplit& split = result.split;
    split.method = "independent halves";
    split.mse_expected_from_noise = sums[Noise] / n;
    split.bias_mse = sums[Product] / n;
    // Where shared noise is small the plugged-in variance can come out below 0.
    const double half_width = z_95 * std::sqrt(std::max(0.0, sums[Plugged])) / n;
    split.mse_overstated = sums[Overstated] / n;
    split.bias_mse_ci95 = {split.bias_mse - half_width,
                           split.bias_mse + split.mse_overstated + half_width};
    split.z_fraction_above_3 = above_threshold(halved, result.variance) / n;
    split.channel_correlation = (rho[0] + rho[1] + rho[2]) / 3;
    split.reference_variance = halves.reference || reference_variance;
    split.test_variance = halves.test || test_variance;
    split.left_out = pair.usable_pixels - std::size_t(sums[Pixels]);
    return result;
}

}  // namespace plumbline::compare
