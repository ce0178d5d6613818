// SPDX-License-Identifier: Apache-2.0
#include "compare/least_squares.h"

#include <ceres/ceres.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scenes/errors.h"

namespace plumbline::compare {

namespace {

/// Where Huber's loss turns linear and the scale of Cauchy's, for 95 % efficiency.
constexpr double huber_k = 1.345;
constexpr double cauchy_c = 2.3849;
/// The median of the square of a standard Gaussian.
constexpr double median_of_square = 0.45493642311957283;
/// Rounds of fitting parameters and misfit in turn, and the relative change of tau that ends them.
constexpr int most_rounds = 10;
constexpr double settled_misfit = 0.01;
constexpr int bisections = 60;
/// Distance from a bound that counts as on it, in the parameter's scale.
constexpr double on_bound = 1e-6;

/// All residuals as one block of one vector of parameters.
class WhitenedCost : public ceres::CostFunction {
 public:
    WhitenedCost(const Prediction& prediction, const Observed& observed, double misfit_variance,
                 Loss loss, std::size_t parameters, std::string& refusal)
        : prediction_(prediction),
          observed_(observed),
          misfit_variance_(misfit_variance),
          loss_(loss),
          refusal_(refusal) {
        set_num_residuals(int(observed.values.size()));
        mutable_parameter_block_sizes()->push_back(std::int32_t(parameters));
    }

    bool Evaluate(const double* const* parameters, double* residuals,
                  double** jacobians) const override {
        const std::vector<double> at(parameters[0], parameters[0] + parameter_block_sizes()[0]);
        const bool with_slopes = jacobians && jacobians[0];
        try {
            Jacobian slopes;
            const auto predicted = prediction_.predict(at, with_slopes ? &slopes : nullptr);
            for (std::size_t i = 0; i < predicted.size(); ++i) {
                const double deviation = std::sqrt(observed_.variance[i] + misfit_variance_);
                const auto [value, slope] =
                    robust(loss_, (predicted[i] - observed_.values[i]) / deviation);
                residuals[i] = value;
                if (with_slopes)
                    Eigen::Map<Eigen::RowVectorXd>(jacobians[0] + i * at.size(),
                                                   Eigen::Index(at.size())) =
                        slopes.row(Eigen::Index(i)) * (slope / deviation);
            }
        } catch (const FitError& error) {
            refusal_ = error.what();  // the solver tries a shorter step
            return false;
        }
        return true;
    }

 private:
    const Prediction& prediction_;
    const Observed& observed_;
    double misfit_variance_;
    Loss loss_;
    std::string& refusal_;
};

/// Passes the solver's iterations on.
struct Watcher : ceres::IterationCallback {
    std::function<void(const ceres::IterationSummary&)> watch;
    ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
        watch(summary);
        return ceres::SOLVER_CONTINUE;
    }
};

void solve_once(const Prediction& prediction, const Observed& observed,
                const std::vector<Parameter>& parameters, const std::vector<int>& held, Loss loss,
                int round, const std::function<void(const Step&)>& watch, Solution& solution) {
    ceres::Problem problem;
    double* values = solution.parameters.data();
    std::string refusal;
    problem.AddResidualBlock(new WhitenedCost(prediction, observed, solution.misfit_variance, loss,
                                              parameters.size(), refusal),
                             nullptr, values);
    for (std::size_t k = 0; k < parameters.size(); ++k) {
        problem.SetParameterLowerBound(values, int(k), parameters[k].lower);
        problem.SetParameterUpperBound(values, int(k), parameters[k].upper);
    }
    if (!held.empty())
        problem.SetManifold(values, new ceres::SubsetManifold(int(parameters.size()), held));
    Watcher watcher;
    watcher.watch = [&](const ceres::IterationSummary& summary) {
        solution.steps.push_back(
            {round, summary.iteration, summary.cost, summary.gradient_max_norm, summary.step_norm});
        watch(solution.steps.back());
    };
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.logging_type = ceres::SILENT;
    options.callbacks.push_back(&watcher);
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    if (!summary.IsSolutionUsable() && !refusal.empty()) throw FitError(refusal);
    if (!summary.IsSolutionUsable())
        throw FitError("fit", "failed: " + summary.message,
                       "check that the reference shows the same scene and frame");
    solution.converged = summary.termination_type == ceres::CONVERGENCE;
    solution.termination = summary.message;
}

/// Whether tau^2 is too small for errors whose squares are given.
bool too_small(const std::vector<double>& squared, const Observed& observed, Loss loss,
               double tau2) {
    if (loss == Loss::Squares) {
        double sum = 0;
        for (std::size_t i = 0; i < squared.size(); ++i)
            sum += squared[i] / (observed.variance[i] + tau2);
        return sum > double(squared.size());
    }
    std::size_t above = 0;
    for (std::size_t i = 0; i < squared.size(); ++i)
        above += squared[i] > median_of_square * (observed.variance[i] + tau2);
    return 2 * above > squared.size();
}

/// Takes the misfit from the errors at the solution; whether it settled.
bool update_misfit(const Prediction& prediction, const Observed& observed, Loss loss,
                   Solution& solution) {
    // Of the errors, not of their losses: what the loss makes small must not shrink the scale.
    std::vector<double> squared = prediction.predict(solution.parameters, nullptr);
    solution.chi_square = 0;
    for (std::size_t i = 0; i < squared.size(); ++i) {
        squared[i] = (squared[i] - observed.values[i]) * (squared[i] - observed.values[i]);
        solution.chi_square += squared[i] / observed.variance[i];
    }
    double low = 0, high = 0;
    if (too_small(squared, observed, loss, 0)) {
        high = *std::max_element(squared.begin(), squared.end());
        if (loss != Loss::Squares) high /= median_of_square;
    }
    for (int step = 0; step < bisections && high > 0; ++step) {
        const double middle = 0.5 * (low + high);
        (too_small(squared, observed, loss, middle) ? low : high) = middle;
    }
    const double before = std::sqrt(solution.misfit_variance), tau = std::sqrt(high);
    solution.misfit_variance = high;
    return std::abs(tau - before) <= settled_misfit * tau;
}

}  // namespace

Loss loss_named(const std::string& name) {
    if (name == "squares") return Loss::Squares;
    if (name == "huber") return Loss::Huber;
    if (name == "cauchy") return Loss::Cauchy;
    throw UsageError("--loss", "'" + name + "' is none", "squares, huber or cauchy");
}

Robust robust(Loss loss, double r) {
    const double size = std::abs(r);
    if (loss == Loss::Huber && size > huber_k) {
        const double root = std::sqrt(2 * huber_k * size - huber_k * huber_k);
        return {std::copysign(root, r), huber_k / root};
    }
    if (loss == Loss::Cauchy && size > 0) {
        // log1p: for small r the logarithm of 1 + r^2 / c^2 would lose all digits.
        const double q = r / cauchy_c;
        const double root = cauchy_c * std::sqrt(std::log1p(q * q));
        if (root > 0) return {std::copysign(root, r), size / ((1 + q * q) * root)};
    }
    return {r, 1};
}

Whitened whitened(const Prediction& prediction, const Observed& observed, double misfit_variance,
                  Loss loss, const std::vector<double>& parameters) {
    Whitened result;
    result.residuals = prediction.predict(parameters, &result.jacobian);
    for (std::size_t i = 0; i < result.residuals.size(); ++i) {
        const double deviation = std::sqrt(observed.variance[i] + misfit_variance);
        const auto [value, slope] =
            robust(loss, (result.residuals[i] - observed.values[i]) / deviation);
        result.residuals[i] = value;
        result.jacobian.row(Eigen::Index(i)) *= slope / deviation;
    }
    return result;
}

void add_bound_notes(const std::vector<Parameter>& parameters, const std::vector<double>& values,
                     std::vector<std::string>& notes) {
    for (std::size_t k = 0; k < parameters.size(); ++k)
        for (double bound : {parameters[k].lower, parameters[k].upper})
            if (parameters[k].free && std::abs(values[k] - bound) <= on_bound * parameters[k].scale)
                notes.push_back(
                    fmt::format("{} ends at its bound {:.5g}", parameters[k].name, bound));
}

Solution solve(const Prediction& prediction, const Observed& observed,
               const std::vector<Parameter>& parameters, const std::vector<std::size_t>& held,
               Loss loss, const std::function<void(const Step&)>& watch) {
    Solution solution;
    std::vector<int> fixed(held.begin(), held.end());
    for (std::size_t k = 0; k < parameters.size(); ++k) {
        solution.parameters.push_back(
            std::clamp(parameters[k].value, parameters[k].lower, parameters[k].upper));
        if (!parameters[k].free) fixed.push_back(int(k));
    }
    std::sort(fixed.begin(), fixed.end());
    fixed.erase(std::unique(fixed.begin(), fixed.end()), fixed.end());
    update_misfit(prediction, observed, loss, solution);
    for (int round = 0; round < most_rounds; ++round) {
        if (fixed.size() < parameters.size())
            solve_once(prediction, observed, parameters, fixed, loss, round, watch, solution);
        if (update_misfit(prediction, observed, loss, solution)) break;
    }
    return solution;
}

}  // namespace plumbline::compare
