// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "compare/fit.h"
#include "compare/thesis_picture.h"

namespace plumbline::compare {

/// The indirect layer of a reference beside the model's picture of the same view.
class Observations {
 public:
    /// Throws FitError if layers are missing or the indirect layer is black.
    explicit Observations(const FitCase& fit_case);

    const ThesisPicture& picture() const { return picture_; }

    /// The pixels that are fitted; then three values a pixel: radiance, and its variance of the
    /// mean, kept above zero.
    const std::vector<std::uint32_t>& pixels() const { return pixels_; }
    const std::vector<double>& radiance() const { return radiance_; }
    const std::vector<double>& variance() const { return variance_; }
    /// In which tile of the picture each of them lies.
    const std::vector<std::uint32_t>& tiles() const { return tiles_; }

    /// All pixels that are finite, and their radiance.
    const std::vector<std::uint32_t>& all_pixels() const { return all_pixels_; }
    const std::vector<double>& all_radiance() const { return all_radiance_; }

 private:
    ThesisPicture picture_;
    std::vector<std::uint32_t> pixels_, all_pixels_, tiles_;
    std::vector<double> radiance_, variance_, all_radiance_;
};

/// The model's best scale on the published pictures of all cases, without weights.
struct BestGain {
    double gain;
    double standard_error;  ///< whatever the residuals' variances [White 1980]
    double rmse_before;     ///< with a gain of 1
    double rmse;
};
BestGain best_gain(const std::vector<Observations>& cases);

/// The unweighted error of the cases, each at its constants.
double rmse_at(std::span<const Observations> cases,
               const std::vector<Constants<double>>& constants);

}  // namespace plumbline::compare
