// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "compare/least_squares.h"

namespace plumbline::compare {

/// A product (or sum) of parameters that can be known although its parts cannot.
struct KnownCombination {
    std::string expression;
    double value;
    double standard_error;
};

/// What the residuals can tell about each parameter.
struct Identifiability {
    std::vector<bool> identifiable;                 ///< false for those that are not free
    std::vector<double> standard_error;             ///< infinite if not identifiable
    std::vector<double> standard_error_covariance;  ///< of independent residuals
    std::vector<double> standard_error_bootstrap;   ///< over tiles
    std::vector<KnownCombination> combinations;
    std::vector<std::string> notes;
    std::vector<std::size_t> redundant;  ///< parameters to hold so that the others can be found
    std::size_t known = 0;               ///< how many directions are
};

/// How parameters act together: constants that scale one another, or gains of layers that add up.
enum class Together { Multiply, Add };

/// Judges the free parameters by the null space of the Jacobian in relative units (steps of each
/// parameter's scale): a direction along which the residuals change by less than 3e-5 of the
/// steepest one cannot be known.
///
/// Standard errors are those of least squares, from the pseudo-inverse of J^T J, which holds for
/// independent residuals; and from 500 bootstrap samples of whole tiles, each answered by one step
/// of Gauss and Newton from the solution [Davidson and MacKinnon 1999], which holds for residuals
/// that are correlated inside a tile, as a model's misfit is. Where the bootstrap's is 1.5 times as
/// large or more, it is the one that is given, and a note says so.
/// Throws FitError if no free parameter changes a value.
Identifiability judge(const Whitened& whitened, const Observed& observed,
                      const std::vector<Parameter>& parameters, const std::vector<double>& values,
                      Together together);

}  // namespace plumbline::compare
