// SPDX-License-Identifier: Apache-2.0
#include "compare/cases_fit.h"

#include <fmt/format.h>

#include <algorithm>

#include "compare/thesis_prediction.h"
#include "scenes/errors.h"

namespace plumbline::compare {

namespace {

/// Beyond this share of a neighbour's light per missed ray, probes take over a thousand updates to
/// converge; at 1 light never dies.
constexpr double most_propagation = 0.98;
constexpr double least_scale = 1e-6;  ///< of constants that multiply: none may be 0
constexpr double most_attenuation = 1e3;
constexpr double most_brightness = 1e9;
constexpr double most_feedback = 1e6;

bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// Constant `c` as a parameter, as published for the first of the cases that share it.
Parameter parameter_of(std::size_t c, const Observations& first, bool free) {
    const double published = first.picture().published()[c];
    const double lossless = first.picture().lossless_falloff();
    const Constants<double> lower{0, least_scale, least_scale, 0};
    const Constants<double> upper{most_propagation * lossless, most_attenuation, most_brightness,
                                  most_feedback};
    // Steps in which constants are told apart: of light passed on, and of each factor.
    const Constants<double> scale{lossless, published, published, std::max(published, 1.0)};
    return {constant_names[c], published, lower[c], upper[c], free, scale[c] > 0 ? scale[c] : 1.0,
            c == 1 || c == 2};
}

Layout layout_of(std::span<const Observations> cases, const std::vector<FitCase>& fit_cases,
                 const FitSettings& settings) {
    Layout layout;
    layout.places.resize(cases.size());
    layout.factors.resize(cases.size());
    for (std::size_t c = 0; c < constant_names.size(); ++c) {
        const std::string name = constant_names[c];
        const bool free = contains(settings.free, name);
        // A constant that is not free stays as published for each scene.
        const bool own = cases.size() > 1 && (!free || contains(settings.per_scene, name));
        for (std::size_t k = 0; k < cases.size(); ++k) {
            if (k == 0 || own) {
                layout.parameters.push_back(parameter_of(c, cases[k], free));
                layout.scenes.push_back(own ? fit_cases[k].scene->name : "");
            }
            layout.places[k][c] = layout.parameters.size() - 1;
            layout.factors[k][c] = own ? 1 : unit_factors(cases.front(), cases[k])[c];
        }
    }
    for (std::size_t p = 0; p < layout.parameters.size(); ++p)
        if (!layout.scenes[p].empty()) layout.parameters[p].name += " (" + layout.scenes[p] + ")";
    return layout;
}

Observed observed_of(std::span<const Observations> cases) {
    Observed observed;
    std::uint32_t first_tile = 0;
    for (const Observations& one : cases) {
        observed.values.insert(observed.values.end(), one.radiance().begin(), one.radiance().end());
        observed.variance.insert(observed.variance.end(), one.variance().begin(),
                                 one.variance().end());
        for (std::uint32_t tile : one.tiles()) observed.tile.push_back(first_tile + tile);
        first_tile = observed.tile.back() + 1;
    }
    return observed;
}

}  // namespace

void check_names(const FitSettings& settings) {
    for (const auto& [option, names] :
         {std::pair("--free", &settings.free), std::pair("--per-scene", &settings.per_scene)})
        for (const std::string& name : *names)
            if (std::find(constant_names.begin(), constant_names.end(), name) ==
                constant_names.end())
                throw UsageError(option, fmt::format("no constant '{}'", name),
                                 fmt::format("name some of {}", fmt::join(constant_names, ", ")));
    for (const std::string& name : settings.per_scene)
        if (!contains(settings.free, name))
            throw UsageError("--per-scene", fmt::format("'{}' is not free", name),
                             "name it with --free too");
    if (settings.free.empty()) throw UsageError("--free", "no constant", "name at least one");
}

CasesFit fit_cases(std::span<const Observations> cases, const std::vector<FitCase>& fit_cases,
                   const FitSettings& settings) {
    CasesFit result;
    result.layout = layout_of(cases, fit_cases, settings);
    const ThesisPrediction prediction(cases, result.layout.places, result.layout.factors,
                                      contains(settings.free, constant_names[3]));
    const Observed observed = observed_of(cases);
    const std::vector<Parameter>& parameters = result.layout.parameters;
    const auto judge_at = [&](const std::vector<double>& at, double misfit_variance) {
        return judge(whitened(prediction, observed, misfit_variance, settings.loss, at), observed,
                     parameters, at, Together::Multiply);
    };
    std::vector<double> start;
    for (const Parameter& one : parameters)
        start.push_back(std::clamp(one.value, one.lower, one.upper));
    result.verdict = judge_at(start, 0);
    result.solution = solve(prediction, observed, parameters, result.verdict.redundant,
                            settings.loss, settings.watch);
    result.verdict = judge_at(result.solution.parameters, result.solution.misfit_variance);
    for (std::size_t k = 0; k < cases.size(); ++k)
        result.constants.push_back(prediction.constants(k, result.solution.parameters));
    result.degrees_of_freedom = double(observed.values.size()) - double(result.verdict.known);
    return result;
}

}  // namespace plumbline::compare
