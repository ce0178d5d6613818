// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "pathtracer/emitters.h"
#include "pathtracer/environment_map.h"
#include "pathtracer/light_choice.h"

namespace plumbline::pathtracer {

/// How light that two techniques can find is shared out between them. All give the same mean.
enum class Techniques {
    Both,         ///< by the balance heuristic [Veach and Guibas 1995, section 3.2]
    AimingOnly,   ///< all to rays aimed at emitters or the environment
    MeetingOnly,  ///< all to paths that run into emitters, or leave the scene
};

/// Which paths are followed, and how far.
struct PathOptions {
    /// What kernels with Effect::EmitterSampling aim at; null if nothing emits.
    const Emitters* emitters = nullptr;
    /// What kernels with Effect::EnvironmentImage aim at; null if there is no picture.
    const EnvironmentMap* environment = nullptr;
    Techniques techniques = Techniques::Both;
    int max_scatterings = std::numeric_limits<int>::max();
    /// Ends paths at random; without it, every path runs to max_scatterings or out of the scene.
    bool roulette = true;
    /// Scatterings before roulette may end a path. This and `sure_throughput` gave the lowest
    /// variance times rays of many settings tried on the library's cornell-box and room-with-door.
    int roulette_start = 5;
    /// Throughput below which roulette becomes likelier to end a path the less it carries.
    float sure_throughput = .25f;
    /// What kernels with Effect::LightChoice choose among; null: every light counts everywhere.
    const LightChoice* lights = nullptr;
};

}  // namespace plumbline::pathtracer
