// SPDX-License-Identifier: Apache-2.0
#include "reports/ablation_groups.h"

namespace plumbline::reports {

namespace {

/// Something that the published probes of irradiance do and the model leaves out, or the reverse.
struct Departure {
    const char* name;
    const char* title;
    std::map<std::string, double> set;
};

const std::vector<Departure>& departures() {
    static const std::vector<Departure> all{
        {"wrap", "probes behind the surface fade", {{"wrapShading", 1}}},
        {"contrast", "visibility cubed", {{"visibilityPower", 3}}},
        {"crush", "small weights crushed", {{"crushThreshold", .2}}},
        {"bias", "biased along normal and view", {{"normalBias", .045}, {"viewBias", .18}}},
        {"gamma", "roots of irradiance blended", {{"perceptualGamma", 5}}},
        {"energy", "surfels take in 95 %", {{"energyPreservation", .95}}},
        {"backs", "backs are black", {{"blackBacks", 1}}},
        {"inside", "probes in something skipped", {{"skipInside", 1}}},
        {"published", "all of these", published_at_rest()},
        {"blind", "no visibility", {{"chebyshev", 0}}},
        {"blurred", "blurred distances", {{"depthSharpness", 1}}}};
    return all;
}

}  // namespace

const std::map<std::string, double>& published_at_rest() {
    static const std::map<std::string, double> set{
        {"published", 1}, {"turnedRays", 0}, {"hysteresis", 0}};
    return set;
}

std::vector<AblationCase> irradiance_cases() {
    std::vector<AblationCase> cases;
    const std::string group = "Irradiance maps with moments of distance";
    ddgi::DdgiOptions options = with_model("irradiance");
    cases.push_back(make_case(group, "irradiance", "irradiance", options));
    for (const Departure& departure : departures()) {
        options.set = departure.set;
        cases.push_back(make_case(group, std::string("irradiance-") + departure.name,
                                  std::string("irradiance, ") + departure.title, options));
    }
    return cases;
}

}  // namespace plumbline::reports
