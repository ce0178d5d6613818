// SPDX-License-Identifier: Apache-2.0
#include "ddgi/irradiance_settings.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <vector>

#include "scenes/errors.h"
#include "scenes/nearest_name.h"

namespace plumbline::ddgi {
namespace {

enum class Kind { Number, Whole };

struct Setting {
    const char* name;
    double IrradianceSettings::*member;
    double least;
    double most;
    Kind kind = Kind::Number;
};

/// A longer memory than any still can be updated for.
constexpr double longest_memory = .999;
/// A lobe a third as wide as a texel: of few rays a texel takes the nearest alone.
constexpr double sharpest = 1000.;

constexpr std::array<Setting, 14> known_settings{
    {{"hysteresis", &IrradianceSettings::hysteresis, 0., longest_memory},
     {"turnedRays", &IrradianceSettings::turnedRays, 0., 1., Kind::Whole},
     {"perceptualGamma", &IrradianceSettings::perceptualGamma, 1., 10.},
     {"normalBias", &IrradianceSettings::normalBias, 0., 1.},
     {"viewBias", &IrradianceSettings::viewBias, 0., 1.},
     {"wrapShading", &IrradianceSettings::wrapShading, 0., 1., Kind::Whole},
     {"crushThreshold", &IrradianceSettings::crushThreshold, 0., 1.},
     {"chebyshev", &IrradianceSettings::chebyshev, 0., 1., Kind::Whole},
     {"visibilityPower", &IrradianceSettings::visibilityPower, 1., 10.},
     {"leastVisibility", &IrradianceSettings::leastVisibility, 0., 1.},
     {"depthSharpness", &IrradianceSettings::depthSharpness, 1., sharpest, Kind::Whole},
     {"energyPreservation", &IrradianceSettings::energyPreservation, 0., 1.},
     {"blackBacks", &IrradianceSettings::blackBacks, 0., 1., Kind::Whole},
     {"skipInside", &IrradianceSettings::skipInside, 0., 1., Kind::Whole}}};

constexpr const char* published = "published";

void take(IrradianceSettings& settings, const std::string& name, double value) {
    std::vector<std::string> names{published};
    for (const Setting& known : known_settings) {
        names.emplace_back(known.name);
        if (name != known.name) continue;
        const bool whole = known.kind != Kind::Whole || value == std::floor(value);
        if (!(value >= known.least && value <= known.most) || !whole)
            throw UsageError("--set " + name, fmt::format("{} is out of range", value),
                             fmt::format("give a {} from {} to {}",
                                         known.kind == Kind::Whole ? "whole number" : "number",
                                         known.least, known.most));
        settings.*known.member = value;
        return;
    }
    throw UsageError("--set " + name,
                     fmt::format("the model irradiance has {}", fmt::join(names, ", ")),
                     did_you_mean(name, names));
}

}  // namespace

IrradianceSettings published_irradiance_settings() {
    // The bias is (0.2 n + 0.8 w_o) 0.75 spacing B with B = 0.3 [Majercik et al. 2021].
    return {.hysteresis = .97,
            .turnedRays = 1.,
            .perceptualGamma = 5.,
            .normalBias = .2 * .75 * .3,
            .viewBias = .8 * .75 * .3,
            .wrapShading = 1.,
            .crushThreshold = .2,
            .chebyshev = 1.,
            .visibilityPower = 3.,
            .leastVisibility = .05,
            .depthSharpness = 50.,
            .energyPreservation = .95,
            .blackBacks = 1.,
            .skipInside = 1.};
}

IrradianceSettings irradiance_settings(const std::map<std::string, double>& set) {
    IrradianceSettings settings;
    if (const auto asked = set.find(published); asked != set.end()) {
        if (asked->second != 0. && asked->second != 1.)
            throw UsageError("--set published", fmt::format("{} is no choice", asked->second),
                             "give 0 or 1");
        if (asked->second == 1.) settings = published_irradiance_settings();
    }
    for (const auto& [name, value] : set)
        if (name != published) take(settings, name, value);
    return settings;
}

std::map<std::string, double> named(const IrradianceSettings& settings) {
    std::map<std::string, double> values;
    for (const Setting& known : known_settings) values[known.name] = settings.*known.member;
    return values;
}

}  // namespace plumbline::ddgi
