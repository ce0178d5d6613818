// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "compare/fit.h"
#include "compare/thesis_picture.h"

namespace plumbline::compare {

/// J^T J of whitened residuals with respect to constants.
using NormalMatrix = Eigen::Matrix3d;

/// What the residuals can tell about each constant.
struct Identifiability {
    Constants<bool> identifiable{};
    Constants<double> standard_error{};  ///< infinite if not identifiable
    std::vector<KnownCombination> combinations;
    std::vector<std::string> notes;
    std::vector<std::size_t> redundant;  ///< constants to hold so that the others can be found
};

/// Judges by the null space of the Jacobian in relative units (steps of `scale` in each constant,
/// which is its value for those that multiply): a direction along which the residuals change by
/// less than 3e-5 of the steepest one cannot be known. Covariance is the pseudo-inverse.
Identifiability judge(const NormalMatrix& normal, const Constants<double>& values,
                      const Constants<double>& scale);

}  // namespace plumbline::compare
