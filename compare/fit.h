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

struct FitResult {
    std::string model;
    std::vector<std::string> scenes;
    std::vector<FittedConstant> constants;
    double rmse_before;  ///< of the indirect layer, at the published constants
    double rmse_after;
    double reduced_chi_square;
    double gain;  ///< of the best single scale on the published picture
    double gain_standard_error;
    double rmse_gain;                ///< error left with that gain alone
    std::vector<std::string> notes;  ///< which combinations can be known, in plain words
};

/// The constants of the thesis's model that match the indirect layer best, in the least-squares
/// sense with weights from the variances. Throws FitError.
FitResult fit(const std::vector<FitCase>& cases);

}  // namespace plumbline::compare
