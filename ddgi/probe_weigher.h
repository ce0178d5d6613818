// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "ddgi/distance_moments.h"
#include "ddgi/probe_options.h"

namespace plumbline::ddgi {

/// What each of the probes around a point counts for it, as ProbeOptions ask. Immutable while
/// threads ask.
class ProbeWeigher {
 public:
    ProbeWeigher(const ProbeGrid& grid, const ProbeOptions& options);

    /// Takes in how far probes see in the world of `cache`, if the options ask for it. `motion`
    /// leads here from the world of the last call; null says that anything may have changed.
    void take_world(const RayTracer& tracer, const SurfelCache& cache, const Motion* motion);

    /// The probes around `x` with their weights, which sum to one. `seen` counts with
    /// ProbeWeights::Visibility only. Where no probe is left the trilinear weights stand: a point
    /// that sees no probe still needs some light.
    ProbeNeighbours weighted(const glm::vec3& x, const glm::vec3& n, std::uint8_t seen) const;

    /// Whether a take_world() can change any weights: those of surfels that see the same probes.
    bool may_change() const { return distances_.has_value(); }
    /// Whether the last take_world() may have changed the weights at `x`.
    bool changed_at(const glm::vec3& x) const;

 private:
    float weight_of(std::size_t probe, bool seen, const glm::vec3& x, const glm::vec3& n,
                    const glm::vec3& biased) const;

    ProbeGrid grid_;
    ProbeOptions options_;
    std::optional<ProbeDistances> distances_;  ///< none: nothing asks for them
    std::optional<DistanceMoments> moments_;
    bool only_seen_ = false;  ///< weights are those of seen_neighbours()
};

}  // namespace plumbline::ddgi
