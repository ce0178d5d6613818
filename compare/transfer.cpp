// SPDX-License-Identifier: Apache-2.0
#include "compare/transfer.h"

#include "compare/cases_fit.h"

namespace plumbline::compare {

namespace {

/// The error on another case of constants that were fitted on one.
TransferError carried(const Constants<double>& constants, const FitCase& from,
                      const Observations& fitted, const FitCase& to, const Observations& tested) {
    Constants<double> there = unit_factors(fitted, tested);
    for (std::size_t c = 0; c < there.size(); ++c) there[c] *= constants[c];
    return {from.scene->name, from.frame, to.scene->name, to.frame, rmse_at({&tested, 1}, {there})};
}

}  // namespace

std::vector<TransferError> transfer_errors(const std::vector<FitCase>& cases,
                                           const FitSettings& settings) {
    check_names(settings);
    std::vector<Observations> observations;
    for (const FitCase& one : cases) observations.emplace_back(one);
    return transfer_errors(cases, observations, settings);
}

std::vector<TransferError> transfer_errors(const std::vector<FitCase>& cases,
                                           std::span<const Observations> observations,
                                           const FitSettings& settings) {
    std::vector<Observations> tests;
    for (const FitCase& one : settings.tests) tests.emplace_back(one);
    std::vector<TransferError> errors;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const Constants<double> constants =
            fit_cases(observations.subspan(i, 1), {cases[i]}, settings).constants.front();
        const auto test = [&](const FitCase& on, const Observations& observed) {
            errors.push_back(carried(constants, cases[i], observations[i], on, observed));
        };
        for (std::size_t j = 0; j < cases.size(); ++j) test(cases[j], observations[j]);
        for (std::size_t j = 0; j < tests.size(); ++j) test(settings.tests[j], tests[j]);
    }
    return errors;
}

}  // namespace plumbline::compare
