// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>

#include "compare/layer_pair.h"

namespace plumbline::compare {

/// How much of the mean squared error the two images' own variances explain.
///
/// Per pixel and channel, d = t - r is taken as Gaussian with mean b (the bias) and variance s^2,
/// the sum of both images' variances of the mean, so E[d^2] = b^2 + s^2: what the MSE has above
/// the mean of s^2 estimates the mean of b^2 without bias of its own.
///
/// The interval is bias_mse +- 1.96 sqrt(V) / n. For two channels of a pixel with noise correlation
/// rho, Cov(d^2, d'^2) = 2 rho^2 s^2 s'^2 + 4 rho s s' b b' (Isserlis), and b b' is estimated by
/// d d' - rho s s', so V adds 4 rho s s' d d' - 2 rho^2 s^2 s'^2 over all pairs of channels, a
/// channel with itself (rho = 1) included. Pixels are independent. V is kept at least at what noise
/// alone gives (b = 0). The variances are taken as exact, which a few samples a pixel do not make
/// them, but for those that overstate (variances_overstate()): the interval then reaches up to
/// where it would lie without them, which is too far rather than not far enough.
///
/// Where the samples of one picture are among those of the other (share_samples()), s^2 is the
/// difference of their variances, as Cov(t, r) is the variance of the one with more.
struct NoiseSplit {
    std::string method = "variance layers";  ///< or "independent halves"
    double mse_expected_from_noise = 0;      ///< mean of s^2
    double mse_overstated = 0;               ///< its part from variances that overstate
    double bias_mse = 0;                     ///< mse - mse_expected_from_noise; may be below 0
    std::array<double, 2> bias_mse_ci95{};
    double z_fraction_above_3 =
        0;  ///< of pixels and channels with |d| > 3 s; 0.0027 if all is Gaussian noise and s is
            ///< exact; if s comes from few batches, as of 16 samples, some percent
    bool shared_samples = false;      ///< one picture's samples are among the other's
    double channel_correlation = 0;   ///< rho, the mean of the three pairs of channels
    bool reference_variance = false;  ///< the reference has variances; else it counts as exact
    bool test_variance = false;
    std::size_t left_out = 0;  ///< finite pixels whose variance is negative or not finite
};

/// The layer that holds the variance of the mean of a layer: "variance" for radiance (""),
/// "variance_indirect" for "indirect".
std::string variance_layer(const std::string& layer);

/// Where the variances of a layer are; none if the image has none.
std::optional<std::array<std::span<const float>, 3>> variances_of(const Image& image,
                                                                  const std::string& layer);

/// The noise correlation of channels R and G, R and B, G and B, in [0,1].
///
/// It comes from the differences between horizontal neighbours, in which a smooth bias cancels:
/// rho = sin(pi/2 mean(sign e sign e')), the quadrant correlation of Gaussians; edges and fireflies
/// can only move the few signs that they touch.
std::array<double, 3> channel_correlations(const LayerPair& pair);

/// The pairs of channels in that order.
inline constexpr std::array<std::array<std::size_t, 2>, 3> channel_pairs{{{0, 1}, {0, 2}, {1, 2}}};

/// Two-sided 95 % point of the Gaussian.
inline constexpr double z_95 = 1.959963984540054;
/// Deviations beyond which z_fraction_above_3 counts.
inline constexpr double z_threshold = 3;

/// Splits the error of a pair made from these images. None if neither has a variance layer, or no
/// pixel has finite variances.
std::optional<NoiseSplit> split_noise(const Image& reference, const Image& test,
                                      const LayerPair& pair);

}  // namespace plumbline::compare
