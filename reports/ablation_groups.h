// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "reports/ablation_cases.h"

namespace plumbline::reports {

/// Groups of the ablation's cases, each in the order of its table: the road from the thesis to
/// conserving, each of its steps alone, and other ways to pass light on;
std::vector<AblationCase> thesis_cases();
/// conserving with more surfels, with each choice changed alone, and with light that surfels share;
std::vector<AblationCase> conserving_cases();
/// the peer, without a bias and with each of its own.
std::vector<AblationCase> irradiance_cases();

/// A case that runs `options`, with what `plumbline ddgi` is told for them.
AblationCase make_case(const std::string& group, const std::string& name, const std::string& title,
                       const ddgi::DdgiOptions& options);

/// The model's defaults.
ddgi::DdgiOptions with_model(const std::string& model);

/// What users call a choice.
template <typename Choice>
const std::string& name_of(const std::map<std::string, Choice>& names, Choice choice) {
    return std::ranges::find(names, choice, [](const auto& named) { return named.second; })->first;
}

/// The peer as published, but for rays that turn: a still has no need of memory, without which they
/// need not.
const std::map<std::string, double>& published_at_rest();

}  // namespace plumbline::reports
