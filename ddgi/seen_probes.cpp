// SPDX-License-Identifier: Apache-2.0
#include "ddgi/seen_probes.h"

#include <cmath>

namespace plumbline::ddgi {
namespace {

/// What a probe straight behind the surface still counts: keeps the weights from all vanishing
/// [Majercik et al. 2019, section 5.2, listing 2: 0.2; less here, since nothing is denoised].
constexpr float least_backface_weight = .05f;

/// In cells: a probe this near to a surface behind it stands in that surface, and its rays start on
/// both sides of it.
constexpr float in_surface = 1e-3f;

/// Cosine between the surface's normal and the way to the probe; 1 where the point is the probe.
float cosine_to(const glm::vec3& way, const glm::vec3& n) {
    const float distance = glm::length(way);
    return distance > 0.f ? glm::dot(way, n) / distance : 1.f;
}

float backface_weight(float cosine) {
    const float wrapped = (cosine + 1.f) / 2.f;
    return wrapped * wrapped + least_backface_weight;
}

}  // namespace

std::uint8_t seen_probes(const RayTracer& tracer, const ProbeGrid& grid, const glm::vec3& x,
                         const glm::vec3& n) {
    const ProbeNeighbours around = probe_neighbours(grid, x);
    unsigned seen = 0;
    for (unsigned k = 0; k < around.probe.size(); ++k) {
        if (around.weight[k] == 0.f) continue;
        const glm::vec3 probe = probe_position(grid, around.probe[k]);
        const glm::vec3 way = probe - x;
        if (glm::dot(way, n) <= 0.f) continue;
        const glm::vec3 beyond = probe + in_surface * grid.spacing * glm::normalize(way);
        if (!tracer.occluded(x, beyond)) seen |= 1u << k;
    }
    return static_cast<std::uint8_t>(seen);
}

Bounds bounds_to_probes(const ProbeGrid& grid, const glm::vec3& x) {
    Bounds bounds{x, x};
    for (const std::uint32_t probe : probe_neighbours(grid, x).probe) {
        bounds.extend(probe_position(grid, probe));
    }
    return bounds.grown(in_surface * grid.spacing);
}

float probe_weight(ProbeWeights weights, const glm::vec3& way, const glm::vec3& n, bool seen) {
    switch (weights) {
        case ProbeWeights::Backface:
            return backface_weight(cosine_to(way, n));
        case ProbeWeights::Visibility:
            return seen ? 1.f : 0.f;
        case ProbeWeights::Moments:
            return cosine_to(way, n) > 0.f ? 1.f : 0.f;
        case ProbeWeights::None:
            break;
    }
    return 1.f;
}

}  // namespace plumbline::ddgi
