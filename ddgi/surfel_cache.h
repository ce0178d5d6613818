// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "ddgi/grid.h"
#include "ddgi/motion.h"
#include "ddgi/patterns.h"
#include "ddgi/seen_probes.h"
#include "ddgi/surfels.h"
#include "scenes/ray_tracer.h"

namespace plumbline::ddgi {

/// How far surfel rays go, and so which of them a moved object can touch.
enum class Reach {
    OneCell,       ///< one cell along each axis [Dellson 2023, section 3.3]
    FirstSurface,  ///< as far as it takes
};

/// The surfels of all probes, traced and lit again only where the world changed.
///
/// A surfel is re-placed if its ray meets a moved object before where it ended, or if it was on a
/// moved object that it no longer meets at the very same point. [Dellson 2023, section 3.6]
/// re-places all surfels of a probe that lies within a cell of a moved object's box.
///
/// After every call the surfels are the ones that tracing all of them afresh would give.
class SurfelCache {
 public:
    /// With ProbeWeights::Visibility surfels know which probes around them they see.
    SurfelCache(const ProbeGrid& grid, RayPattern pattern, Reach reach,
                ProbeWeights weights = ProbeWeights::None);

    /// Places and lights every surfel.
    void rebuild(const RayTracer& tracer);
    /// Places and lights those that `motion` touches; `motion` leads from the world of the last
    /// call to that of `tracer`.
    void refresh(const RayTracer& tracer, const Motion& motion);

    const Surfels& surfels() const { return surfels_; }
    const RayPattern& pattern() const { return pattern_; }
    const ProbeGrid& grid() const { return grid_; }
    /// Whether the last call placed this surfel.
    bool replaced(std::size_t surfel) const { return to_place_[surfel] != 0; }
    /// Whether the last call may have changed anything of this surfel.
    bool changed(std::size_t surfel) const {
        return to_place_[surfel] != 0 || to_light_[surfel] != 0 ||
               (!to_see_.empty() && to_see_[surfel] != 0);
    }
    /// How many surfels are on a surface.
    std::uint64_t hits() const { return hits_; }

    /// What the last call did, and what it took.
    struct Figures {
        double place_ms = 0;
        double light_ms = 0;
        std::uint64_t replaced = 0;
        std::uint64_t shadow_rays = 0;
    };
    const Figures& figures() const { return figures_; }

 private:
    void mark_touched(const World& world, const Motion& motion);
    bool touched(const RayTracer& movers, const Motion& motion, std::size_t surfel) const;
    void place_marked(const RayTracer& tracer);
    void mark_shadows(const World& world, const Motion& motion);
    void light_marked(const RayTracer& tracer);
    bool within_reach(const Motion& motion, std::size_t probe) const;
    std::vector<std::uint8_t> moved_cells(const Motion& motion) const;
    void see_probes(const RayTracer& tracer, const Motion* motion);
    void place(const RayTracer& tracer, std::size_t surfel);
    bool is_at(const Hit& hit, const World& world, std::size_t surfel) const;
    Ray ray_of(std::size_t surfel) const;

    ProbeGrid grid_;
    RayPattern pattern_;
    Reach reach_;
    Surfels surfels_;
    std::vector<std::uint8_t> to_place_;  ///< one a surfel
    std::vector<std::uint8_t> to_light_;  ///< one a surfel
    std::vector<std::uint8_t> to_see_;    ///< one a surfel; empty if nobody asks for seen probes
    std::uint64_t hits_ = 0;
    Figures figures_;
};

}  // namespace plumbline::ddgi
