// SPDX-License-Identifier: Apache-2.0
#include "reports/ablation_cases.h"

#include <fmt/core.h>

#include <array>

namespace plumbline::reports {

namespace {

/// A step of the model `steps`, in the order in which the road takes them.
struct Step {
    const char* constant;
    const char* name;
    const char* title;
};

constexpr std::array<Step, 6> steps{
    {{"receiverAlbedo", "receiver-albedo", "receiver albedo"},
     {"solidAngle", "solid-angle", "solid angle instead of cosine over squared distance"},
     {"octantLookUp", "octant-look-up", "octants integrated at the look-up, no constants"},
     {"evenRays", "even-rays", "rays of equal solid angle"},
     {"firstSurface", "first-surface", "rays to the first surface"},
     {"multiBounce", "multi-bounce", "multiple bounces"}}};

AblationCase make_case(const std::string& group, const std::string& name, const std::string& title,
                       const ddgi::DdgiOptions& options) {
    std::string text = "--model " + options.model;
    if (options.surfels != ddgi::DdgiOptions{}.surfels)
        text += fmt::format(" --surfels {}", options.surfels);
    for (const auto& [constant, value] : options.set)
        text += fmt::format(" --set {}={}", constant, value);
    return {group, name, title, text, options};
}

ddgi::DdgiOptions with_model(const std::string& model) {
    ddgi::DdgiOptions options;
    options.model = model;
    return options;
}

/// Each step on top of those before it.
void add_road(std::vector<AblationCase>& cases) {
    const std::string group = "From the thesis to conserving, a step at a time";
    cases.push_back(make_case(group, "thesis", "thesis as published", with_model("thesis")));
    ddgi::DdgiOptions options = with_model("steps");
    for (const Step& step : steps) {
        options.set[step.constant] = 1;
        cases.push_back(make_case(group, std::string("road-") + step.name,
                                  std::string("+ ") + step.title, options));
    }
}

void add_single_steps(std::vector<AblationCase>& cases) {
    for (const Step& step : steps) {
        ddgi::DdgiOptions options = with_model("steps");
        options.set[step.constant] = 1;
        cases.push_back(make_case("One step alone from the thesis",
                                  std::string("only-") + step.name,
                                  std::string("thesis, ") + step.title, options));
    }
}

void add_surfels(std::vector<AblationCase>& cases) {
    for (const int surfels : {64, 128, 256}) {
        ddgi::DdgiOptions options = with_model("conserving");
        options.surfels = surfels;
        cases.push_back(make_case("Conserving, the default", fmt::format("conserving-{}", surfels),
                                  fmt::format("conserving, {} surfels a probe", surfels), options));
    }
}

}  // namespace

std::vector<AblationCase> ablation_cases() {
    std::vector<AblationCase> cases;
    add_road(cases);
    add_single_steps(cases);
    add_surfels(cases);
    return cases;
}

}  // namespace plumbline::reports
