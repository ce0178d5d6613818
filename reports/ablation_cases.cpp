// SPDX-License-Identifier: Apache-2.0
#include "reports/ablation_cases.h"

#include <fmt/core.h>

#include <algorithm>

#include "reports/ablation_groups.h"
#include "scenes/errors.h"
#include "scenes/nearest_name.h"

namespace plumbline::reports {

namespace {

/// What `plumbline ddgi` is told for the choices of conserving that are not the default.
std::string choices_text(const ddgi::DdgiOptions& options) {
    const ddgi::ProbeOptions& chosen = options.probes;
    const ddgi::ProbeOptions usual;
    std::string text;
    if (chosen.storage != usual.storage)
        text += " --storage " + name_of(ddgi::storage_names, chosen.storage);
    if (chosen.weights != usual.weights)
        text += " --weights " + name_of(ddgi::weights_names, chosen.weights);
    if (chosen.feedback != usual.feedback)
        text += " --feedback " + name_of(ddgi::feedback_names, chosen.feedback);
    if (!chosen.shifted) text += " --no-shift";
    if (!chosen.parallax) text += " --no-parallax";
    if (chosen.normal_bias != usual.normal_bias)
        text += fmt::format(" --normal-bias {}", chosen.normal_bias);
    if (chosen.skip_inside) text += " --skip-inside";
    if (options.share != ddgi::DdgiOptions{}.share)
        text += fmt::format(" --share {}", options.share);
    if (options.edge_samples) text += fmt::format(" --edge-samples {}", *options.edge_samples);
    return text;
}

}  // namespace

AblationCase make_case(const std::string& group, const std::string& name, const std::string& title,
                       const ddgi::DdgiOptions& options) {
    std::string text = "--model " + options.model;
    if (options.surfels != ddgi::DdgiOptions{}.surfels)
        text += fmt::format(" --surfels {}", options.surfels);
    for (const auto& [constant, value] : options.set)
        text += fmt::format(" --set {}={}", constant, value);
    return {group, name, title, text + choices_text(options), options};
}

ddgi::DdgiOptions with_model(const std::string& model) {
    ddgi::DdgiOptions options;
    options.model = model;
    return options;
}

std::vector<AblationCase> ablation_cases() {
    std::vector<AblationCase> cases;
    for (const auto& group : {thesis_cases(), conserving_cases(), irradiance_cases()})
        cases.insert(cases.end(), group.begin(), group.end());
    return cases;
}

std::vector<AblationCase> ablation_cases(const std::vector<std::string>& names) {
    std::vector<AblationCase> cases = ablation_cases();
    std::vector<std::string> known;
    known.reserve(cases.size());
    for (const AblationCase& one : cases) known.push_back(one.name);
    for (const std::string& name : names) {
        if (std::ranges::find(known, name) != known.end()) continue;
        throw UsageError("--only", fmt::format("there is no case '{}'", name),
                         did_you_mean(name, known));
    }
    std::erase_if(cases, [&](const AblationCase& one) {
        return std::ranges::find(names, one.name) == names.end();
    });
    return cases;
}

std::vector<AblationCase> leak_cases() {
    const std::string group = "Leak";
    std::vector<AblationCase> cases{
        make_case(group, "thesis", "thesis as published", with_model("thesis"))};
    ddgi::DdgiOptions irradiance = with_model("irradiance");
    cases.push_back(make_case(group, "irradiance", "irradiance", irradiance));
    irradiance.set = published_at_rest();
    cases.push_back(
        make_case(group, "irradiance-published", "irradiance as published", irradiance));
    const auto add = [&](ddgi::Storage storage, ddgi::ProbeWeights weights) {
        ddgi::DdgiOptions options = with_model("conserving");
        options.probes.storage = storage;
        options.probes.weights = weights;
        const std::string& keeps = name_of(ddgi::storage_names, storage);
        const std::string& counts = name_of(ddgi::weights_names, weights);
        cases.push_back(make_case(group, fmt::format("{}-{}", keeps, counts),
                                  fmt::format("conserving, {}, weights: {}", keeps, counts),
                                  options));
    };
    for (const auto& [storage_name, storage] : ddgi::storage_names) {
        // How light is kept by direction hardly matters for what passes a wall.
        if (storage != ddgi::Storage::Rays && storage != ddgi::Storage::Octants) {
            add(storage, ddgi::ProbeOptions{}.weights);
            continue;
        }
        for (const auto& [weights_name, weights] : ddgi::weights_names) add(storage, weights);
    }
    return cases;
}

}  // namespace plumbline::reports
