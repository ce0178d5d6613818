// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace plumbline::compare {

/// Values by row, parameters by column.
using Jacobian = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// One number that a fit may choose.
struct Parameter {
    std::string name;
    double value;  ///< where the fit starts
    double lower, upper;
    bool free = true;
    double scale;             ///< a step in which it is told apart from others
    bool multiplies = false;  ///< its step is its own size, wherever it is
};

/// What a model predicts for a list of observed values.
class Prediction {
 public:
    virtual ~Prediction() = default;
    /// The predicted values, and their derivatives unless `jacobian` is null. Throws FitError where
    /// the model has no answer.
    virtual std::vector<double> predict(const std::vector<double>& parameters,
                                        Jacobian* jacobian) const = 0;
};

/// The observed values, their variances (above 0), and in which tile of a picture each lies; tiles
/// count from 0.
struct Observed {
    std::vector<double> values, variance;
    std::vector<std::uint32_t> tile;
};

/// What a large residual r costs, in place of r^2.
///
/// With residuals of unit variance, Huber (2 k |r| - k^2 beyond k = 1.345) and Cauchy
/// (c^2 log(1 + r^2 / c^2), c = 2.385) keep 95 % of the efficiency of squares where errors are
/// Gaussian [Holland and Welsch 1977].
enum class Loss { Squares, Huber, Cauchy };

/// "squares", "huber" or "cauchy". Throws UsageError.
Loss loss_named(const std::string& name);

/// sqrt(cost of r) with the sign of r: what is squared and summed; and its derivative in r.
struct Robust {
    double value, slope;
};
Robust robust(Loss loss, double r);

/// One iteration of the solver.
struct Step {
    int round, iteration;
    double cost;      ///< half the sum of squared (or robust) residuals
    double gradient;  ///< the largest component, along the parameters in their scales
    double step;      ///< length of the step, in the parameters' own units
};

/// Parameters that fit best, and how well.
struct Solution {
    std::vector<double> parameters;
    double misfit_variance = 0;  ///< tau^2, see solve()
    double chi_square = 0;       ///< sum of e^2 / s^2, with the observations' noise alone
    std::vector<Step> steps;
    bool converged = false;
    std::string termination;  ///< the solver's last word
};

/// Residuals r = (prediction - observed) / sqrt(s^2 + tau^2) at parameters, as the loss weighs
/// them.
struct Whitened {
    std::vector<double> residuals;
    Jacobian jacobian;  ///< of the residuals, not held parameters included
};
Whitened whitened(const Prediction& prediction, const Observed& observed, double misfit_variance,
                  Loss loss, const std::vector<double>& parameters);

/// The parameters that minimise the sum of losses of r, by Levenberg and Marquardt within bounds
/// (Ceres), those in `held` and those that are not free left at their start.
///
/// tau, the standard deviation of the model's own error, is found in turns with the parameters such
/// that residuals have unit variance, 0 if noise explains them; with a robust loss such that the
/// median of r^2 is that of a squared Gaussian. Noise weights alone would let the values with the
/// least noise decide between parameters none of which is right.
/// `watch` is told each step. Throws FitError if the solver fails.
Solution solve(const Prediction& prediction, const Observed& observed,
               const std::vector<Parameter>& parameters, const std::vector<std::size_t>& held,
               Loss loss, const std::function<void(const Step&)>& watch);

/// Adds a line for each free parameter that ended at a bound.
void add_bound_notes(const std::vector<Parameter>& parameters, const std::vector<double>& values,
                     std::vector<std::string>& notes);

}  // namespace plumbline::compare
