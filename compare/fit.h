// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scenes/image.h"
#include "scenes/scene.h"

namespace plumbline::compare {

/// A scene at a frame with its ground truth.
struct FitCase {
    const Scene* scene;
    int frame;
    const Image* reference;  ///< with the layers indirect and variance_indirect
};

/// A constant as the fit found it.
struct FittedConstant {
    std::string name;
    double value;
    double standard_error;  ///< infinite if not identifiable
    bool identifiable;      ///< false: only a product with others can be known
};

/// A product of constants that can be known although its factors cannot.
struct KnownCombination {
    std::string expression;
    double value;
    double standard_error;
};

/// The error of one scene under constants that were fitted on one (another, or the same).
struct TransferError {
    std::string fitted_on;
    std::string tested_on;
    double rmse;
};

struct FitResult {
    std::string model;
    std::vector<std::string> scenes;
    std::vector<FittedConstant> constants;
    double rmse_before;  ///< of the indirect layer, at the published constants
    double rmse_after;
    double reduced_chi_square;  ///< with the references' noise alone: about 1 if that is all
    double gain;                ///< of the best single scale on the published picture
    double gain_standard_error;
    double rmse_gain;                ///< error left with that gain alone
    std::vector<std::string> notes;  ///< which combinations can be known, in plain words
    std::vector<KnownCombination> combinations;
    std::vector<TransferError> transfer;  ///< of several cases: fitted on each, tested on each
    double misfit = 0;  ///< standard deviation of the model's own error, see fit()
};

/// The constants of the thesis's model that match the indirect layer best, shared by all cases.
///
/// falloffRegulator, bounceAttenuation and probeBrightness are free. Residual: (E_model - E_ref) /
/// sqrt(s^2 + tau^2) per pixel and channel, where s^2 is the reference's variance of the mean and
/// tau is the model's misfit, chosen so that the residuals have unit variance; 0 if noise explains
/// them. Noise weights alone would let the darkest pixels, where noise is least,
/// decide between constants none of which is right. s^2 is kept at least at 1e-3 of its mean and at
/// (1e-6 of the layer's root mean square)^2: a pixel that happened to see no light has an estimated
/// variance of zero and would divide by it. At most about 20,000 pixels of a lattice are
/// fitted; every rmse is unweighted, of all pixels and channels, noise included.
///
/// Of constants that act only as a product, the first is kept at its published value.
/// Standard errors are those of weighted least squares with independent residuals; a model's misfit
/// is not independent from pixel to pixel, so where it dominates they are too small.
/// Throws FitError if there is no case, a layer is missing, the truth is black, or no constant
/// has an effect.
FitResult fit(const std::vector<FitCase>& cases);

}  // namespace plumbline::compare
