// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>

#include "ddgi/thesis_model.h"
#include "scenes/errors.h"
#include "scenes/nearest_name.h"
#include "scenes/world.h"

namespace plumbline::ddgi {
namespace {

/// The Cornell Box of [Dellson 2023], for its spacing of 20.
constexpr ThesisConstants cornell_box = {680.f, 0.105f, 26.2f, 5.4f, 0.07f, 1.f};
constexpr float cornell_box_spacing = 20.f;

struct NamedConstant {
    const char* name;
    float ThesisConstants::*member;
};

constexpr std::array<NamedConstant, 6> named_constants = {{
    {"falloffRegulator", &ThesisConstants::falloffRegulator},
    {"bounceAttenuation", &ThesisConstants::bounceAttenuation},
    {"probeBrightness", &ThesisConstants::probeBrightness},
    {"multiBounceIntensity", &ThesisConstants::multiBounceIntensity},
    {"ambient", &ThesisConstants::ambient},
    {"imageBrightness", &ThesisConstants::imageBrightness},
}};

void override_constant(ThesisConstants& constants, const std::string& name, double value) {
    for (const NamedConstant& known : named_constants) {
        if (name != known.name) continue;
        if (!std::isfinite(value) || value < 0.) {
            throw UsageError("--set " + name, fmt::format("{} is not a scale", value),
                             "give a number from 0 on");
        }
        constants.*known.member = static_cast<float>(value);
        return;
    }
    std::vector<std::string> names;
    for (const NamedConstant& known : named_constants) names.emplace_back(known.name);
    throw UsageError("--set " + name,
                     fmt::format("the model thesis has {}", fmt::join(names, ", ")),
                     did_you_mean(name, names));
}

}  // namespace

ThesisConstants thesis_constants(const Scene& scene, const ProbeGrid& grid,
                                 const std::map<std::string, double>& set,
                                 std::vector<std::string>& notes) {
    ThesisConstants constants = scene.thesis.value_or(cornell_box);
    const float set_for = scene.thesis ? probe_grid(scene).spacing : cornell_box_spacing;
    if (!scene.thesis) {
        notes.push_back(
            fmt::format("scene '{}' has no constants for the model thesis; taking the "
                        "Cornell Box's",
                        scene.name));
    }
    if (grid.spacing != set_for) {
        const float scale = grid.spacing / set_for;
        constants.falloffRegulator *= scale * scale;
        if (!set.contains("falloffRegulator")) {
            notes.push_back(fmt::format(
                "falloffRegulator is scaled to {} for a spacing of {} instead of {}, so that a "
                "missed ray still brings {} of the neighbour's light",
                constants.falloffRegulator, grid.spacing, set_for,
                constants.falloffRegulator / (2.f * grid.spacing * grid.spacing)));
        }
    }
    constants.multiBounceIntensity = 0.f;
    for (const auto& [name, value] : set) override_constant(constants, name, value);
    return constants;
}

}  // namespace plumbline::ddgi
