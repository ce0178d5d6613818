// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "compare/identifiability.h"
#include "scenes/image.h"
#include "scenes/scene.h"

namespace plumbline::compare {

/// A scene at a frame with its ground truth.
struct FitCase {
    const Scene* scene;
    int frame;
    const Image* reference;  ///< with the layers indirect and variance_indirect
};

/// What a fit may choose, and how.
struct FitSettings {
    /// Names of free constants; the others stay as published.
    std::vector<std::string> free{"falloffRegulator", "bounceAttenuation", "probeBrightness"};
    std::vector<std::string> per_scene;  ///< those of them that each scene has for itself
    Loss loss = Loss::Squares;
    std::vector<FitCase> tests;  ///< further cases on which the constants are only tested
    std::function<void(const Step&)> watch = [](const Step&) {};
};

/// A constant, or a layer's gain, as the fit found it.
struct FittedConstant {
    std::string name;
    double value;
    double standard_error;  ///< see Identifiability; infinite if not identifiable
    bool identifiable;      ///< false: only a product with others can be known
    std::string scene{};    ///< whose it is; empty: shared by all
    double standard_error_covariance = 0;
    double standard_error_bootstrap = 0;
};

/// The error of one scene under constants that were fitted on one (another, or the same).
struct TransferError {
    std::string fitted_on;
    int fitted_frame;
    std::string tested_on;
    int tested_frame;
    double rmse;
};

struct FitResult {
    std::string model;
    std::vector<std::string> scenes;
    std::vector<FittedConstant> constants;  ///< the free ones
    double rmse_before;                     ///< of the indirect layer, at the published constants
    double rmse_after;
    double reduced_chi_square;  ///< with the references' noise alone: about 1 if that is all
    double gain;                ///< of the best single scale on the published picture
    double gain_standard_error;
    double rmse_gain;                ///< error left with that gain alone
    std::vector<std::string> notes;  ///< which combinations can be known, in plain words
    std::vector<KnownCombination> combinations;
    std::vector<TransferError> transfer;  ///< fitted on each case, tested on each and on the tests
    double misfit = 0;                    ///< standard deviation of the model's own error: tau
    std::vector<Step> steps{};
    bool converged = false;
    /// What each case in order was rendered with: the free constants by name.
    std::vector<std::map<std::string, double>> case_constants{};
};

/// The constants of the thesis's model that match the indirect layer best, over all cases.
///
/// Residual: (E_model - E_ref) / sqrt(s^2 + tau^2) per pixel and channel, where s^2 is the
/// reference's variance of the mean and tau is the model's misfit, see solve(). s^2 is kept at
/// least at 1e-3 of its mean and at (1e-6 of the layer's root mean square)^2: a pixel that happened
/// to see no light has an estimated variance of zero and would divide by it. At most about 20,000
/// pixels of a lattice are fitted; every rmse is unweighted, of all pixels and channels, noise
/// included.
///
/// Of constants that act only as a product, the first is kept at its published value. Bounds:
/// falloffRegulator where a missed ray brings 0 to 0.98 of the neighbour's light, the others from
/// above 0 up; multiBounceIntensity from 0 up, as far as its feedback converges.
/// Throws FitError if there is no case, a layer is missing, the truth is black, or no constant
/// has an effect; UsageError for a constant that there is not.
FitResult fit(const std::vector<FitCase>& cases, const FitSettings& settings = {});

}  // namespace plumbline::compare
