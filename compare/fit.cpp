// SPDX-License-Identifier: Apache-2.0
#include "compare/fit.h"

#include <ceres/ceres.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/identifiability.h"
#include "compare/indirect_residual.h"
#include "scenes/errors.h"

namespace plumbline::compare {

namespace {

/// Beyond this share of a neighbour's light per missed ray, probes take over a thousand updates to
/// converge; at 1 light never dies.
constexpr double most_propagation = 0.98;
constexpr double least_scale = 1e-6;  ///< of constants that multiply: none may be 0
constexpr double most_attenuation = 1e3;
constexpr double most_brightness = 1e9;
/// Rounds of fitting constants and misfit in turn, and the relative change of tau that ends them.
constexpr int most_rounds = 10;
constexpr double settled_misfit = 0.01;
constexpr int bisections = 60;

struct Solution {
    Constants<double> constants;
    double misfit = 0;  ///< tau^2
    Identifiability verdict;
    double chi_square = 0;  ///< with noise alone
    double degrees_of_freedom = 0;
};

Constants<double> upper_bounds(std::span<const Observations> cases) {
    double falloff = std::numeric_limits<double>::infinity();
    for (const Observations& one : cases)
        falloff = std::min(falloff, most_propagation * one.picture().lossless_falloff());
    return {falloff, most_attenuation, most_brightness};
}

/// Steps in which constants are told apart: of light passed on, and of each factor.
Constants<double> scale_of(std::span<const Observations> cases,
                           const Constants<double>& constants) {
    return {cases.front().picture().lossless_falloff(), constants[1], constants[2]};
}

void solve(std::span<const Observations> cases, Solution& solution) {
    ceres::Problem problem;
    double* constants = solution.constants.data();
    for (std::size_t k = 0; k < cases.size(); ++k)
        problem.AddResidualBlock(IndirectResidual::cost_function(cases[k], solution.misfit),
                                 nullptr, constants);
    const Constants<double> upper = upper_bounds(cases);
    const Constants<double> lower{0, least_scale, least_scale};
    for (int k = 0; k < int(upper.size()); ++k) {
        problem.SetParameterLowerBound(constants, k, lower[std::size_t(k)]);
        problem.SetParameterUpperBound(constants, k, upper[std::size_t(k)]);
    }
    if (!solution.verdict.redundant.empty()) {
        std::vector<int> held(solution.verdict.redundant.begin(), solution.verdict.redundant.end());
        std::sort(held.begin(), held.end());
        held.erase(std::unique(held.begin(), held.end()), held.end());
        problem.SetManifold(constants, new ceres::SubsetManifold(int(upper.size()), held));
    }
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    if (!summary.IsSolutionUsable())
        throw FitError("thesis", "the fit failed: " + summary.message,
                       "check that the reference shows the same scene and frame");
}

/// What the fit leaves of each value, with the reference's noise.
struct Errors {
    std::vector<double> squared, variance;
};

Errors errors_at(std::span<const Observations> cases, const Constants<double>& constants) {
    Errors errors;
    for (const Observations& one : cases) {
        for (double e : model_errors(one, constants)) errors.squared.push_back(e * e);
        errors.variance.insert(errors.variance.end(), one.variance().begin(), one.variance().end());
    }
    return errors;
}

/// tau^2 such that the mean of e^2 / (s^2 + tau^2) is 1; 0 if noise suffices.
double misfit_of(const Errors& errors) {
    const auto excess = [&](double tau2) {
        double sum = 0;
        for (std::size_t i = 0; i < errors.squared.size(); ++i)
            sum += errors.squared[i] / (errors.variance[i] + tau2);
        return sum / double(errors.squared.size()) - 1;
    };
    if (excess(0) <= 0) return 0;
    double low = 0, high = *std::max_element(errors.squared.begin(), errors.squared.end());
    for (int step = 0; step < bisections; ++step) {
        const double middle = 0.5 * (low + high);
        (excess(middle) > 0 ? low : high) = middle;
    }
    return high;
}

/// Takes the misfit from the errors at the solution; whether it settled.
bool update_misfit(std::span<const Observations> cases, Solution& solution) {
    const Errors errors = errors_at(cases, solution.constants);
    const double tau = std::sqrt(misfit_of(errors));
    const bool settled = std::abs(tau - std::sqrt(solution.misfit)) <= settled_misfit * tau;
    solution.misfit = tau * tau;
    solution.chi_square = 0;
    for (std::size_t i = 0; i < errors.squared.size(); ++i)
        solution.chi_square += errors.squared[i] / errors.variance[i];
    solution.degrees_of_freedom = double(errors.squared.size());
    return settled;
}

void judge_solution(std::span<const Observations> cases, Solution& solution) {
    NormalMatrix normal = NormalMatrix::Zero();
    for (std::size_t k = 0; k < cases.size(); ++k)
        normal += normal_matrix(cases[k], solution.misfit, solution.constants);
    solution.verdict = judge(normal, solution.constants, scale_of(cases, solution.constants));
}

Solution fit_cases(std::span<const Observations> cases) {
    Solution solution;
    solution.constants = cases.front().picture().published();
    const Constants<double> upper = upper_bounds(cases);
    for (std::size_t k = 0; k < upper.size(); ++k)
        solution.constants[k] =
            std::clamp(solution.constants[k], k == 0 ? 0 : least_scale, upper[k]);
    update_misfit(cases, solution);
    judge_solution(cases, solution);
    for (int round = 0; round < most_rounds; ++round) {
        solve(cases, solution);
        if (update_misfit(cases, solution)) break;
    }
    judge_solution(cases, solution);
    double free = 0;
    for (bool identifiable : solution.verdict.identifiable) free += double(identifiable);
    solution.degrees_of_freedom -= free + double(solution.verdict.combinations.size());
    return solution;
}

void note_bounds(std::span<const Observations> cases, const Solution& solution, FitResult& result) {
    const double most = upper_bounds(cases)[0];
    if (solution.constants[0] > (1 - 1e-6) * most)
        result.notes.push_back(fmt::format(
            "falloffRegulator ends at its bound {:.5g}, where a missed ray brings {} of the "
            "neighbour's light",
            most, most_propagation));
    if (solution.constants[0] < 1e-9 * most)
        result.notes.push_back("falloffRegulator ends at its bound 0");
}

void add_transfer(const std::vector<FitCase>& cases, const std::vector<Observations>& observations,
                  FitResult& result) {
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const Solution one = fit_cases({&observations[i], 1});
        for (std::size_t j = 0; j < cases.size(); ++j)
            result.transfer.push_back({cases[i].scene->name, cases[j].scene->name,
                                       rmse_at({&observations[j], 1}, one.constants)});
    }
}

}  // namespace

FitResult fit(const std::vector<FitCase>& cases) {
    if (cases.empty()) throw FitError("fit", "no scene", "name at least one");
    std::vector<Observations> observations;
    for (const FitCase& one : cases) observations.emplace_back(one);
    const BestGain gain = best_gain(observations);
    const Solution solution = fit_cases(observations);

    FitResult result{};
    result.model = "thesis";
    for (const FitCase& one : cases) result.scenes.push_back(one.scene->name);
    for (std::size_t k = 0; k < constant_names.size(); ++k)
        result.constants.push_back({constant_names[k], solution.constants[k],
                                    solution.verdict.standard_error[k],
                                    solution.verdict.identifiable[k]});
    result.rmse_before = gain.rmse_before;
    result.rmse_after = rmse_at(observations, solution.constants);
    result.reduced_chi_square = solution.chi_square / solution.degrees_of_freedom;
    result.gain = gain.gain;
    result.gain_standard_error = gain.standard_error;
    result.rmse_gain = gain.rmse;
    result.notes = solution.verdict.notes;
    result.combinations = solution.verdict.combinations;
    result.misfit = std::sqrt(solution.misfit);
    note_bounds(observations, solution, result);
    if (cases.size() > 1) add_transfer(cases, observations, result);
    return result;
}

}  // namespace plumbline::compare
