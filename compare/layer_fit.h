// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "compare/fit.h"

namespace plumbline::compare {

/// A layer of anybody's renderer, and what to call its gain.
struct GainLayer {
    std::string name;
    const Image* image;
    std::string layer;  ///< "" is radiance
};

/// What gains are sought for.
struct LayerFitSettings {
    std::string layer;  ///< of the reference; "" is radiance
    double lower = 0;   ///< bounds of every gain
    double upper = std::numeric_limits<double>::max();
    Loss loss = Loss::Squares;
    std::function<void(const Step&)> watch = [](const Step&) {};
};

/// The gains g_k with which sum_k g_k layer_k matches the reference best, as fit() finds constants:
/// weights, misfit, identifiability and standard errors are the same, and `rmse_before` is that of
/// gains of 1. Where the reference has no variances the misfit is all there is, and the reduced
/// chi-square is not a number. Throws ImageError if sizes differ or a layer is missing; FitError.
FitResult fit_layers(const std::vector<GainLayer>& layers, const Image& reference,
                     const LayerFitSettings& settings);

}  // namespace plumbline::compare
