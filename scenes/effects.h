// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scenes/scene.h"

namespace plumbline {

/// What a scene may call for; kernels take the set as a template argument, so that what a scene
/// does not call for is compiled out.
enum class Effect : unsigned {
    PointLights = 1u << 0,  ///< without size, alike in every direction
    Emission = 1u << 1,
    Environment = 1u << 2,
    SphereLights = 1u << 3,  ///< point lights with a radius
    SpotLights = 1u << 4,
    DirectionalLights = 1u << 5,
    EmitterSampling = 1u << 6,   ///< aiming at surfaces that emit
    EnvironmentImage = 1u << 7,  ///< of unlike pixels, aimed at
    LightChoice = 1u << 8,       ///< one point, spot or sphere light at a time in place of all
};

/// A set of Effect, usable as a template argument.
struct Effects {
    unsigned bits = 0;
    constexpr bool operator==(const Effects&) const = default;
};

constexpr bool has(Effects effects, Effect effect) {
    return (effects.bits & static_cast<unsigned>(effect)) != 0;
}
/// Whether everything in `some` is in `all` too.
constexpr bool covers(Effects all, Effects some) { return (some.bits & ~all.bits) == 0; }
constexpr Effects operator|(Effects a, Effects b) { return {a.bits | b.bits}; }
constexpr Effects operator|(Effects effects, Effect effect) {
    return {effects.bits | static_cast<unsigned>(effect)};
}

/// The smallest set without which the scene's picture would change.
Effects effects_of(const Scene& scene);

/// An effect and why it is simulated or skipped, in plain words.
struct EffectReason {
    std::string effect;
    bool simulated;
    std::string why;
};

/// Every effect the program knows of, with what the scene calls for and why.
std::vector<EffectReason> effect_reasons(const Scene& scene);

}  // namespace plumbline
