// SPDX-License-Identifier: Apache-2.0
#include "compare/identifiability.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

#include "scenes/errors.h"

namespace plumbline::compare {

namespace {

/// Of eigenvalues, relative to the largest: the square of 3e-5. Dual numbers leave about 1e-16.
constexpr double null_eigenvalue = 1e-9;
/// How far a unit vector's entries may be from those it is recognised by.
constexpr double tolerance = 1e-3;

using Eigen::Vector3d;

/// The constants i < j if moving along `null` multiplies one by what it divides the other.
bool is_product(const Vector3d& null, std::size_t i, std::size_t j) {
    Vector3d exchange = Vector3d::Zero();
    exchange[int(i)] = 1 / std::sqrt(2.0);
    exchange[int(j)] = -1 / std::sqrt(2.0);
    return (null - exchange).norm() < tolerance || (null + exchange).norm() < tolerance;
}

/// The first entry that is as large as any.
std::size_t leading(const Vector3d& v) {
    std::size_t best = 0;
    for (std::size_t k = 1; k < 3; ++k)
        if (std::abs(v[int(k)]) > std::abs(v[int(best)]) + tolerance) best = k;
    return best;
}

void describe(const Vector3d& null, const Eigen::Matrix3d& covariance,
              const Constants<double>& values, Identifiability& verdict) {
    for (std::size_t i = 0; i < 3; ++i) {
        if (std::abs(null[int(i)]) > 1 - tolerance) {
            verdict.notes.push_back(fmt::format("{} has no effect", constant_names[i]));
            return;
        }
        for (std::size_t j = i + 1; j < 3; ++j) {
            if (!is_product(null, i, j)) continue;
            Vector3d log_product = Vector3d::Zero();
            log_product[int(i)] = log_product[int(j)] = 1;
            const double value = values[i] * values[j];
            const double error = value * std::sqrt(log_product.dot(covariance * log_product));
            verdict.combinations.push_back(
                {fmt::format("{} x {}", constant_names[i], constant_names[j]), value, error});
            verdict.notes.push_back(fmt::format(
                "{} and {} act only as their product, which is {:.5g} +- {:.2g}; each alone "
                "cannot be known",
                constant_names[i], constant_names[j], value, error));
            return;
        }
    }
    verdict.notes.push_back("a combination of the constants has no effect");
}

}  // namespace

Identifiability judge(const NormalMatrix& normal, const Constants<double>& values,
                      const Constants<double>& scale) {
    const Eigen::DiagonalMatrix<double, 3> steps(scale[0], scale[1], scale[2]);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(steps * normal * steps);
    const double largest = solver.eigenvalues()[2];
    if (!(largest > 0))
        throw FitError("thesis", "no constant changes the picture",
                       "the camera must see a surface that the probes light");

    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  // in steps
    std::vector<Vector3d> null_space;
    for (int k = 0; k < 3; ++k) {
        const Vector3d v = solver.eigenvectors().col(k);
        if (solver.eigenvalues()[k] < null_eigenvalue * largest)
            null_space.push_back(v);
        else
            covariance += v * v.transpose() / solver.eigenvalues()[k];
    }

    Identifiability verdict;
    for (std::size_t k = 0; k < 3; ++k) {
        double in_null_space = 0;
        for (const Vector3d& v : null_space) in_null_space += v[int(k)] * v[int(k)];
        verdict.identifiable[k] = in_null_space < tolerance * tolerance;
        verdict.standard_error[k] = verdict.identifiable[k]
                                        ? scale[k] * std::sqrt(covariance(int(k), int(k)))
                                        : std::numeric_limits<double>::infinity();
    }
    for (const Vector3d& v : null_space) {
        describe(v, covariance, values, verdict);
        verdict.redundant.push_back(leading(v));
    }
    return verdict;
}

}  // namespace plumbline::compare
