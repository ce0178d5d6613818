// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "compare/fit.h"
#include "compare/identifiability.h"
#include "compare/least_squares.h"
#include "compare/observations.h"
#include "compare/thesis_prediction.h"

namespace plumbline::compare {

/// The parameters of a fit, and which of them each case reads.
struct Layout {
    std::vector<Parameter> parameters;
    std::vector<std::string> scenes;  ///< whose each is; empty: shared
    ConstantPlaces places;
    std::vector<Constants<double>> factors;  ///< of each case, see ThesisPrediction
};

/// A fit of some cases.
struct CasesFit {
    Layout layout;
    Solution solution;
    Identifiability verdict;
    std::vector<Constants<double>> constants;  ///< of each case
    double degrees_of_freedom;
};

/// Throws UsageError if `free` or `per_scene` name what cannot be fitted.
void check_names(const FitSettings& settings);

/// Fits constants to all of `cases` at once; `fit_cases` are what they were made of.
CasesFit fit_cases(std::span<const Observations> cases, const std::vector<FitCase>& fit_cases,
                   const FitSettings& settings);

}  // namespace plumbline::compare
