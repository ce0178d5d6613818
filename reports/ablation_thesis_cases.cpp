// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "reports/ablation_groups.h"

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

/// All other steps taken, what a ray brings that meets nothing within a cell.
void add_propagation(std::vector<AblationCase>& cases) {
    const std::string group = "Where rays of one cell look that meet nothing";
    ddgi::DdgiOptions options = with_model("steps");
    for (const Step& step : steps)
        if (std::string(step.constant) != "firstSurface") options.set[step.constant] = 1;
    cases.push_back(
        make_case(group, "pass-thesis", "a share of the neighbour, inward at borders", options));
    const auto add = [&](const char* constant, const char* name, const char* title) {
        ddgi::DdgiOptions other = options;
        other.set[constant] = 1;
        cases.push_back(make_case(group, name, title, other));
    };
    add("diagonalNeighbour", "pass-diagonal", "the neighbour on the diagonal, whole");
    add("gridAtEnd", "pass-grid", "the grid where the ray ends");
}

}  // namespace

std::vector<AblationCase> thesis_cases() {
    std::vector<AblationCase> cases;
    add_road(cases);
    add_single_steps(cases);
    add_propagation(cases);
    return cases;
}

}  // namespace plumbline::reports
