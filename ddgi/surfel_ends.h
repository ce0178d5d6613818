// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "ddgi/grid.h"
#include "ddgi/motion_marker.h"
#include "ddgi/surfels.h"
#include "scenes/ray_tracer.h"

namespace plumbline::ddgi {

/// Where the rays of some surfels end in a world, traced together: at most lane_count of them.
class SurfelEnds {
 public:
    explicit SurfelEnds(const RayTracer& tracer) : tracer_(tracer) {}

    /// Traces the rays of `which`, in ascending order.
    void trace(const ProbeGrid& grid, const MotionMarker& marker, const Surfels& surfels,
               std::span<const std::size_t> which);

    /// Whose ray i is.
    std::size_t probe(std::size_t i) const { return probe_[i]; }
    /// Whether ray i of these ends where its surfel is.
    bool is_at(const Surfels& surfels, std::size_t i) const;
    /// Puts the surfel of ray i there.
    void put(Surfels& surfels, std::size_t i) const;

 private:
    static constexpr std::int32_t missed = -1;

    void offset_positions();

    const RayTracer& tracer_;
    std::span<const std::size_t> which_;
    Lanes<std::uint32_t> probe_;
    RayLanes rays_;
    HitLanes hits_;
    Lanes3 position_;          ///< of hits, off their surfaces
    Lanes<std::int32_t> hit_;  ///< of each ray, the number of its hit, or `missed`
};

}  // namespace plumbline::ddgi
