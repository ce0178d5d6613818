// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "ddgi/grid.h"
#include "scenes/ray_tracer.h"

namespace plumbline::ddgi {

/// How the trilinear weights of the probes around a point are tempered.
enum class ProbeWeights {
    None,      ///< trilinear alone
    Backface,  ///< probes behind the surface fade out smoothly [Majercik et al. 2019, section 5.2]
    Visibility,  ///< probes behind the surface, or behind another, do not count: exact, by rays
};

/// All probes around a point, for weights that do not ask which are seen.
constexpr std::uint8_t all_probes = 0xff;

/// Bit k is set if probe k around a point can be seen from it: it stands in front of the surface
/// with unit normal `n`, and nothing lies between or right behind it: a probe that stands in a
/// wall's face has rays on both sides of the wall. `x` is just off the surface.
std::uint8_t seen_probes(const RayTracer& tracer, const ProbeGrid& grid, const glm::vec3& x,
                         const glm::vec3& n);

/// The smallest box around `x` and all the probes that seen_probes() asks for: nothing outside it
/// can change the answer.
Bounds bounds_to_probes(const ProbeGrid& grid, const glm::vec3& x);

/// The probes around `x` with their weights, which sum to one.
///
/// Where no probe is left the trilinear weights stand: a point that sees no probe still needs
/// some light.
ProbeNeighbours weighted_probes(const ProbeGrid& grid, const glm::vec3& x, const glm::vec3& n,
                                ProbeWeights weights, std::uint8_t seen);

}  // namespace plumbline::ddgi
