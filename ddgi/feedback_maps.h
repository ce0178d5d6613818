// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "ddgi/grid.h"
#include "ddgi/irradiance_map.h"
#include "ddgi/ray_gather.h"

namespace plumbline::ddgi {

/// What a surface point gathers from the maps around it: sum_k weight_k sum_i at_i E(probe_k,
/// node_i) over the probes that count for it.
struct MapGather {
    std::uint32_t first = 0;        ///< the lowest node of the lowest probe around the point
    std::uint32_t probes = 0;       ///< how many count; above, three bits each, which of the eight
    std::array<float, 8> weight{};  ///< of these
    std::array<float, 4> at{};      ///< of the nodes around the normal; 1 is first if one has all
};

/// Maps of irradiance that each probe makes of its rays once an update, for surfels to gather from.
///
/// Only what some surfel asked for is made: most probes are not next to a surface, and most
/// surfaces face an axis, where one node alone counts.
class FeedbackMaps {
 public:
    explicit FeedbackMaps(const ProbeGrid& grid);

    /// What a point with unit normal `n` gathers from the probes `around` it, all of which lie in
    /// one cell. make() makes it from now on. Threads may call this at the same time.
    MapGather gather(const ProbeNeighbours& around, const glm::vec3& n);

    /// Makes the irradiances at the nodes that were asked for, of the rays' radiance, `values` as a
    /// model keeps them.
    void make(const RayEnds& ends, std::span<const float> values, std::size_t rays) const;

    /// E[i] becomes the irradiance, W m^-2, that gathers[i] tells of the maps last made.
    void gather(std::span<const MapGather> gathers, std::span<Spectrum> E) const;

 private:
    /// Node by node, as surfaces face few ways, and on each lie probes next to each other: what
    /// surfels gather from then fits into the second-level cache.
    std::uint32_t index(std::size_t node, std::size_t probe) const {
        return static_cast<std::uint32_t>(node * asked_.size() + probe);
    }

    /// How much further than the lowest of the eight probes around a point each is.
    std::array<std::uint32_t, 8> corner_offsets_;
    std::vector<std::uint64_t> asked_;  ///< one a probe: bit i if node i was asked for
    /// Irradiances at the nodes of all probes; what make() writes, kept as new memory is slow.
    std::unique_ptr<glm::vec4[]> nodes_;
};

/// pi times the mean of the rays' radiance; 0 if no ray counts.
Spectrum irradiance(const RaySums& sums);

}  // namespace plumbline::ddgi
