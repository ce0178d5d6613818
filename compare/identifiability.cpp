// SPDX-License-Identifier: Apache-2.0
#include "compare/identifiability.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

#include "compare/tile_bootstrap.h"
#include "scenes/errors.h"

namespace plumbline::compare {

namespace {

/// Of eigenvalues, relative to the largest: the square of 3e-5. Dual numbers leave about 1e-16.
constexpr double null_eigenvalue = 1e-9;
/// How far a direction may be from those it is recognised by.
constexpr double tolerance = 1e-3;
/// From this ratio of standard errors on, residuals are taken as correlated.
constexpr double correlated_ratio = 1.5;

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The free parameters in their scales, split in what can be known and what cannot.
struct Directions {
    std::vector<std::size_t> free;  ///< indices of parameters
    VectorXd scale;                 ///< of the free ones
    MatrixXd known;                 ///< orthonormal columns
    MatrixXd null;                  ///< orthonormal columns
    MatrixXd covariance;            ///< in scales, zero along null
};

Directions directions_of(const Whitened& whitened, const std::vector<Parameter>& parameters,
                         const std::vector<double>& values) {
    Directions result;
    for (std::size_t k = 0; k < parameters.size(); ++k)
        if (parameters[k].free) result.free.push_back(k);
    const Index n = Index(result.free.size());
    MatrixXd slopes(whitened.jacobian.rows(), n);
    result.scale.resize(n);
    for (Index k = 0; k < n; ++k) {
        const std::size_t parameter = result.free[std::size_t(k)];
        result.scale[k] = parameters[parameter].multiplies ? std::abs(values[parameter])
                                                           : parameters[parameter].scale;
        slopes.col(k) = whitened.jacobian.col(Index(parameter)) * result.scale[k];
    }
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(slopes.transpose() * slopes);
    const VectorXd& eigenvalues = solver.eigenvalues();  // ascending
    if (n == 0 || !(eigenvalues[n - 1] > 0))
        throw FitError("fit", "no free constant changes the picture",
                       "free one that acts, and let the camera see a surface that it lights");
    Index unknown = 0;
    while (eigenvalues[unknown] < null_eigenvalue * eigenvalues[n - 1]) ++unknown;
    result.null = solver.eigenvectors().leftCols(unknown);
    result.known = solver.eigenvectors().rightCols(n - unknown);
    result.covariance = result.known * eigenvalues.tail(n - unknown).cwiseInverse().asDiagonal() *
                        result.known.transpose();
    return result;
}

/// How much of a unit vector lies in the null space.
double share_in_null(const Directions& directions, const VectorXd& v) {
    return directions.null.cols() == 0 ? 0 : (directions.null.transpose() * v).norm();
}

/// Two standard errors of a direction, in scales.
struct DirectionErrors {
    double covariance, bootstrap;
    bool correlated() const { return bootstrap >= correlated_ratio * covariance; }
    double used() const { return correlated() ? bootstrap : covariance; }
};

DirectionErrors errors_along(const Directions& directions, const MatrixXd& bootstrap,
                             const VectorXd& v) {
    return {std::sqrt(v.dot(directions.covariance * v)), std::sqrt(v.dot(bootstrap * v))};
}

void describe_pairs(const Directions& directions, const MatrixXd& bootstrap,
                    const std::vector<Parameter>& parameters, const std::vector<double>& values,
                    Together together, Identifiability& verdict) {
    const Index n = directions.scale.size();
    for (Index i = 0; i < n; ++i)
        for (Index j = i + 1; j < n; ++j) {
            // Moving along the exchange multiplies one by what it divides the other (or adds to one
            // what it takes from the other); the sum of steps is that of the product's logarithm.
            VectorXd exchange = VectorXd::Zero(n), both = VectorXd::Zero(n);
            exchange[i] = std::sqrt(0.5);
            exchange[j] = -exchange[i];
            both[i] = both[j] = 1;
            if (share_in_null(directions, exchange) < 1 - tolerance) continue;
            if (share_in_null(directions, VectorXd::Unit(n, i)) > 1 - tolerance) continue;
            const std::size_t a = directions.free[std::size_t(i)];
            const std::size_t b = directions.free[std::size_t(j)];
            const bool multiply = together == Together::Multiply;
            const double value = multiply ? values[a] * values[b] : values[a] + values[b];
            const double step = multiply ? value : directions.scale[i];
            const double error = step * errors_along(directions, bootstrap, both).used();
            verdict.combinations.push_back({fmt::format("{} {} {}", parameters[a].name,
                                                        multiply ? "x" : "+", parameters[b].name),
                                            value, error});
            verdict.notes.push_back(
                fmt::format("{} and {} act only as their {}, which is {:.5g} +- {:.2g}; each alone "
                            "cannot be known",
                            parameters[a].name, parameters[b].name, multiply ? "product" : "sum",
                            value, error));
        }
}

/// One parameter for each direction that cannot be known, the ones that it moves most.
void choose_redundant(Directions directions, Identifiability& verdict) {
    MatrixXd& null = directions.null;
    for (Index left = null.cols(); left > 0; --left) {
        Index best = 0;
        for (Index k = 1; k < null.rows(); ++k)
            if (null.row(k).norm() > null.row(best).norm() + tolerance) best = k;
        verdict.redundant.push_back(directions.free[std::size_t(best)]);
        const VectorXd along = null.row(best).normalized();
        null -= null * along * along.transpose();
    }
}

}  // namespace

Identifiability judge(const Whitened& whitened, const Observed& observed,
                      const std::vector<Parameter>& parameters, const std::vector<double>& values,
                      Together together) {
    const Directions directions = directions_of(whitened, parameters, values);
    const Index n = directions.scale.size();
    const MatrixXd bootstrap = directions.scale.cwiseInverse().asDiagonal() *
                               tile_bootstrap(whitened, observed, directions.free,
                                              directions.scale.asDiagonal() * directions.known) *
                               directions.scale.cwiseInverse().asDiagonal();
    Identifiability verdict;
    verdict.identifiable.assign(parameters.size(), false);
    for (auto* errors : {&verdict.standard_error, &verdict.standard_error_covariance,
                         &verdict.standard_error_bootstrap})
        errors->assign(parameters.size(), std::numeric_limits<double>::infinity());
    bool correlated = false;
    for (Index k = 0; k < n; ++k) {
        const std::size_t parameter = directions.free[std::size_t(k)];
        const VectorXd unit = VectorXd::Unit(n, k);
        const double unknown = share_in_null(directions, unit);
        if (unknown > 1 - tolerance)
            verdict.notes.push_back(parameters[parameter].name + " has no effect");
        verdict.identifiable[parameter] = unknown < tolerance;
        if (!verdict.identifiable[parameter]) continue;
        const DirectionErrors errors = errors_along(directions, bootstrap, unit);
        verdict.standard_error[parameter] = directions.scale[k] * errors.used();
        verdict.standard_error_covariance[parameter] = directions.scale[k] * errors.covariance;
        verdict.standard_error_bootstrap[parameter] = directions.scale[k] * errors.bootstrap;
        correlated = correlated || errors.correlated();
    }
    describe_pairs(directions, bootstrap, parameters, values, together, verdict);
    choose_redundant(directions, verdict);
    verdict.known = std::size_t(directions.known.cols());
    if (directions.null.cols() > 0 && verdict.notes.empty())
        verdict.notes.push_back("a combination of the constants has no effect");
    if (correlated)
        verdict.notes.push_back(
            "what is left is correlated from pixel to pixel: standard errors are those of a "
            "bootstrap over tiles");
    return verdict;
}

}  // namespace plumbline::compare
