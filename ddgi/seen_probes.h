// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "ddgi/cell_planes.h"
#include "ddgi/grid.h"
#include "scenes/ray_tracer.h"

namespace plumbline::ddgi {

/// How the trilinear weights of the probes around a point are tempered.
enum class ProbeWeights {
    None,      ///< trilinear alone
    Backface,  ///< probes behind the surface fade out smoothly [Majercik et al. 2019, section 5.2]
    Visibility,  ///< probes behind the surface, or behind another, do not count: exact, by rays
    Moments,     ///< the same without rays, by what is known of distances: see DistanceMoments
};

/// Bit k is set if probe k around a point can be seen from it: it stands in front of the surface
/// with unit normal `n`, and nothing lies between or right behind it: a probe that stands in a
/// wall's face has rays on both sides of the wall. `x` is just off the surface.
std::uint8_t seen_probes(const RayTracer& tracer, const ProbeGrid& grid, const glm::vec3& x,
                         const glm::vec3& n);

/// The same for many points at once, whose rays are traced together where `planes` of the tracer's
/// world leave any to be traced: seen[i] becomes seen_probes(tracer, grid, x[i], n[i]).
void seen_probes(const RayTracer& tracer, const ProbeGrid& grid, const CellPlanes& planes,
                 std::span<const glm::vec3> x, std::span<const glm::vec3> n,
                 std::span<std::uint8_t> seen);

/// The probes around `x` with trilinear weights, of those only that are `seen` and made to sum to
/// one; the trilinear weights themselves if none is: tempered() by ProbeWeights::Visibility.
ProbeNeighbours seen_neighbours(const ProbeGrid& grid, const glm::vec3& x, std::uint8_t seen);

/// The smallest box around `x` and all the probes that seen_probes() asks for: nothing outside it
/// can change the answer.
Bounds bounds_to_probes(const ProbeGrid& grid, const glm::vec3& x);

/// What a probe counts beside its trilinear weight for a surface with unit normal `n`, which is
/// `way` from it; `seen` tells whether it is seen.
float probe_weight(ProbeWeights weights, const glm::vec3& way, const glm::vec3& n, bool seen);

/// Each weight of `trilinear` times weight_of(k, probe), made to sum to one; `trilinear` itself if
/// none is left: a point that sees no probe still needs some light.
template <typename Weight>
ProbeNeighbours tempered(const ProbeNeighbours& trilinear, const Weight& weight_of) {
    ProbeNeighbours around = trilinear;
    float sum = 0.f;
    for (std::size_t k = 0; k < around.probe.size(); ++k) {
        if (around.weight[k] != 0.f) around.weight[k] *= weight_of(k, around.probe[k]);
        sum += around.weight[k];
    }
    // Of denormal weights no digits would be left.
    if (sum < std::numeric_limits<float>::min()) return trilinear;
    for (float& weight : around.weight) weight /= sum;
    return around;
}

}  // namespace plumbline::ddgi
