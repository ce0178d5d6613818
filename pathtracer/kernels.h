// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "pathtracer/lights.h"

namespace plumbline::pathtracer {

/// The sets of effects that the path tracer is compiled for, each before those that cover it.
/// Plain point lights have kernels of their own; all other lights share theirs. Aiming at emitters
/// needs emission.
inline constexpr auto kernels = [] {
    constexpr std::array lights{Effects{}, Effects{} | Effect::PointLights, any_light};
    constexpr std::array emission{Effects{}, Effects{} | Effect::Emission,
                                  Effects{} | Effect::Emission | Effect::EmitterSampling};
    constexpr std::array environment{Effects{}, Effects{} | Effect::Environment};
    std::array<Effects, lights.size() * emission.size() * environment.size()> sets{};
    std::size_t i = 0;
    for (const Effects from_lights : lights) {
        for (const Effects from_surfaces : emission) {
            for (const Effects from_sky : environment) {
                sets[i++] = from_lights | from_surfaces | from_sky;
            }
        }
    }
    return sets;
}();

}  // namespace plumbline::pathtracer
