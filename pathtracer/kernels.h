// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cassert>

#include "pathtracer/lights.h"

namespace plumbline::pathtracer {

/// The sets of effects that the path tracer is compiled for, each before those that cover it.
/// Plain point lights have kernels of their own; all other lights share theirs. Aiming at emitters
/// needs emission. A picture of the environment, or a choice among many lights, costs so much more
/// than what else a scene may lack that one kernel serves all scenes that have one.
inline constexpr auto kernels = [] {
    constexpr std::array lights{Effects{}, Effects{} | Effect::PointLights, any_light};
    constexpr std::array emission{Effects{}, Effects{} | Effect::Emission,
                                  Effects{} | Effect::Emission | Effect::EmitterSampling};
    constexpr std::array environment{Effects{}, Effects{} | Effect::Environment};
    std::array<Effects, lights.size() * emission.size() * environment.size() + 2> sets{};
    std::size_t i = 0;
    for (const Effects from_lights : lights) {
        for (const Effects from_surfaces : emission) {
            for (const Effects from_sky : environment) {
                sets[i++] = from_lights | from_surfaces | from_sky;
            }
        }
    }
    sets[i] = sets[i - 1] | Effect::EnvironmentImage;
    sets[i + 1] = sets[i] | Effect::LightChoice;
    return sets;
}();

/// Calls `f` with the template argument of the smallest kernel there is for `effects`.
template <std::size_t kernel = 0, typename Function>
void with_effects(Effects effects, const Function& f) {
    if constexpr (kernel < kernels.size()) {
        constexpr Effects F = kernels[kernel];
        if (covers(F, effects)) return f.template operator()<F>();
        with_effects<kernel + 1>(effects, f);
    } else {
        assert(!"an effect that the path tracer has no kernel for");
    }
}

}  // namespace plumbline::pathtracer
