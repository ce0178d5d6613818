// SPDX-License-Identifier: Apache-2.0
#include "ddgi/probe_weigher.h"

#include <algorithm>

namespace plumbline::ddgi {
namespace {

/// The published exponent of distance maps [Majercik et al. 2019].
constexpr int distance_sharpness = 50;

}  // namespace

ProbeWeigher::ProbeWeigher(const ProbeGrid& grid, const ProbeOptions& options)
    : grid_(grid), options_(options) {
    if (options.weights == ProbeWeights::Moments) moments_.emplace(grid, distance_sharpness);
    if (moments_ || options.skip_inside) distances_.emplace();
    only_seen_ =
        options.weights == ProbeWeights::Visibility && !distances_ && options.normal_bias == 0.f;
}

void ProbeWeigher::take_world(const RayTracer& tracer, const SurfelCache& cache,
                              const Motion* motion) {
    if (distances_) distances_->trace(tracer, cache, motion);
    if (moments_) moments_->take(*distances_, cache.surfels());
}

bool ProbeWeigher::changed_at(const glm::vec3& x) const {
    return distances_ &&
           std::ranges::any_of(probe_neighbours(grid_, x).probe,
                               [&](std::uint32_t probe) { return distances_->changed(probe); });
}

float ProbeWeigher::weight_of(std::size_t probe, bool seen, const glm::vec3& x, const glm::vec3& n,
                              const glm::vec3& biased) const {
    if (options_.skip_inside && distances_->inside(probe)) return 0.f;
    if (options_.weights == ProbeWeights::Visibility) return seen ? 1.f : 0.f;
    const glm::vec3 way = probe_position(grid_, static_cast<std::uint32_t>(probe)) - x;
    const float weight = probe_weight(options_.weights, way, n, seen);
    return moments_ && weight > 0.f ? weight * moments_->visibility(probe, biased) : weight;
}

ProbeNeighbours ProbeWeigher::weighted(const glm::vec3& x, const glm::vec3& n,
                                       std::uint8_t seen) const {
    if (only_seen_) return seen_neighbours(grid_, x, seen);
    const glm::vec3 biased = x + options_.normal_bias * grid_.spacing * n;
    return tempered(probe_neighbours(grid_, x, biased), [&](std::size_t k, std::uint32_t probe) {
        return weight_of(probe, (seen >> k & 1) != 0, x, n, biased);
    });
}

}  // namespace plumbline::ddgi
