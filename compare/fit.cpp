// SPDX-License-Identifier: Apache-2.0
#include "compare/fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/cases_fit.h"
#include "compare/transfer.h"
#include "scenes/errors.h"

namespace plumbline::compare {

namespace {

/// Says in whose unit shared constants are given, where scenes have others.
void add_unit_note(const std::vector<Observations>& observations, const std::vector<FitCase>& cases,
                   std::vector<std::string>& notes) {
    for (std::size_t k = 1; k < observations.size(); ++k)
        if (unit_factors(observations[0], observations[k]) != Constants<double>{1, 1, 1, 1}) {
            notes.push_back(fmt::format(
                "shared constants are given for {}; all but bounceAttenuation are areas, and go "
                "with the square of the spacing to the other scenes",
                cases[0].scene->name));
            return;
        }
}

/// The free ones among a case's constants, by name.
std::map<std::string, double> free_constants(const Constants<double>& constants,
                                             const FitSettings& settings) {
    std::map<std::string, double> named;
    for (const std::string& name : settings.free)
        named[name] = constants[static_cast<std::size_t>(std::ranges::find(constant_names, name) -
                                                         constant_names.begin())];
    return named;
}

}  // namespace

FitResult fit(const std::vector<FitCase>& cases, const FitSettings& settings) {
    if (cases.empty()) throw FitError("fit", "no scene", "name at least one");
    check_names(settings);
    std::vector<Observations> observations;
    for (const FitCase& one : cases) observations.emplace_back(one);
    const BestGain gain = best_gain(observations);
    const CasesFit fitted = fit_cases(observations, cases, settings);

    FitResult result{};
    result.model = "thesis";
    for (const FitCase& one : cases) result.scenes.push_back(one.scene->name);
    const Identifiability& verdict = fitted.verdict;
    for (std::size_t c = 0, p = 0; p < fitted.layout.parameters.size(); ++p) {
        while (!fitted.layout.parameters[p].name.starts_with(constant_names[c])) ++c;
        if (fitted.layout.parameters[p].free)
            result.constants.push_back(
                {constant_names[c], fitted.solution.parameters[p], verdict.standard_error[p],
                 verdict.identifiable[p], fitted.layout.scenes[p],
                 verdict.standard_error_covariance[p], verdict.standard_error_bootstrap[p]});
    }
    result.rmse_before = gain.rmse_before;
    result.rmse_after = rmse_at(observations, fitted.constants);
    result.reduced_chi_square = fitted.solution.chi_square / fitted.degrees_of_freedom;
    result.gain = gain.gain;
    result.gain_standard_error = gain.standard_error;
    result.rmse_gain = gain.rmse;
    result.notes = verdict.notes;
    result.combinations = verdict.combinations;
    result.misfit = std::sqrt(fitted.solution.misfit_variance);
    result.steps = fitted.solution.steps;
    result.converged = fitted.solution.converged;
    if (!result.converged)
        result.notes.push_back("the fit did not converge: " + fitted.solution.termination);
    add_bound_notes(fitted.layout.parameters, fitted.solution.parameters, result.notes);
    add_unit_note(observations, cases, result.notes);
    for (const Constants<double>& constants : fitted.constants)
        result.case_constants.push_back(free_constants(constants, settings));
    if (cases.size() + settings.tests.size() > 1)
        result.transfer = transfer_errors(cases, observations, settings);
    return result;
}

}  // namespace plumbline::compare
