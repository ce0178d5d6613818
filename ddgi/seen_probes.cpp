// SPDX-License-Identifier: Apache-2.0
#include "ddgi/seen_probes.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "ddgi/occlusion.h"

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

/// Calls ask(k, end) for each probe k around `x` that counts and stands in front of the surface; it
/// is seen if nothing lies between `x` and `end`.
template <typename Ask>
void for_probes_in_front(const ProbeGrid& grid, const glm::vec3& x, const glm::vec3& n,
                         const Ask& ask) {
    const ProbeNeighbours around = probe_neighbours(grid, x);
    const std::array<glm::vec3, 8> positions = neighbour_positions(grid, x);
    for (unsigned k = 0; k < around.probe.size(); ++k) {
        if (around.weight[k] == 0.f) continue;
        const glm::vec3& probe = positions[k];
        const glm::vec3 way = probe - x;
        if (glm::dot(way, n) <= 0.f) continue;
        ask(k, probe + in_surface * grid.spacing * glm::normalize(way));
    }
}

}  // namespace

std::uint8_t seen_probes(const RayTracer& tracer, const ProbeGrid& grid, const glm::vec3& x,
                         const glm::vec3& n) {
    unsigned seen = 0;
    for_probes_in_front(grid, x, n, [&](unsigned k, const glm::vec3& end) {
        if (!tracer.occluded(x, end)) seen |= 1u << k;
    });
    return static_cast<std::uint8_t>(seen);
}

void seen_probes(const RayTracer& tracer, const ProbeGrid& grid, std::span<const glm::vec3> x,
                 std::span<const glm::vec3> n, std::span<std::uint8_t> seen) {
    struct Question {
        std::size_t point;
        unsigned probe;
    };
    std::vector<Question> questions;
    std::vector<Segment> ways;
    for (std::size_t i = 0; i < x.size(); ++i) {
        for_probes_in_front(grid, x[i], n[i], [&](unsigned k, const glm::vec3& end) {
            questions.push_back({i, k});
            ways.push_back({x[i], end});
        });
    }
    const std::vector<std::uint8_t> hidden = occluded(tracer, ways);
    std::ranges::fill(seen, std::uint8_t{0});
    for (std::size_t i = 0; i < questions.size(); ++i) {
        if (hidden[i] != 0) continue;
        const auto [point, probe] = questions[i];
        seen[point] = static_cast<std::uint8_t>(seen[point] | 1u << probe);
    }
}

Bounds bounds_to_probes(const ProbeGrid& grid, const glm::vec3& x) {
    Bounds bounds{x, x};
    for (const glm::vec3& probe : neighbour_positions(grid, x)) bounds.extend(probe);
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
