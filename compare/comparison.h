// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "scenes/image.h"

namespace plumbline::compare {

/// Error of a test image against a reference; each formula stands in metrics.h.
struct Metrics {
    double bias = 0;
    double mae = 0;
    double rmse = 0;
    double relmse = 0;
    double smape = 0;
    double psnr_db = 0;
    double ssim = 0;
    std::optional<double> flip;
};

/// How much of the mean squared error the two images' own variances explain.
struct NoiseSplit {
    double mse_expected_from_noise = 0;  ///< mean of both variances of the mean
    double bias_mse = 0;                 ///< mse - mse_expected_from_noise
    std::array<double, 2> bias_mse_ci95{};
    double z_fraction_above_3 = 0;  ///< of pixels and channels; 0.0027 if all is noise
};

struct Comparison {
    Metrics metrics;
    std::optional<NoiseSplit> noise;  ///< none: neither image has a variance layer
    std::size_t non_finite = 0;       ///< values that are not finite in either, left out of the metrics
    std::size_t pixels = 0;
};

/// Compares a layer ("" is radiance) of two images of the same size.
/// Throws ImageError if sizes differ or a layer is missing.
Comparison compare_images(const Image& reference, const Image& test, const std::string& layer);

}  // namespace plumbline::compare
