// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "ddgi/cell_planes.h"
#include "ddgi/grid.h"
#include "ddgi/motion.h"
#include "ddgi/motion_marker.h"
#include "ddgi/patterns.h"
#include "ddgi/seen_probes.h"
#include "ddgi/step_times.h"
#include "ddgi/surfel_cells.h"
#include "ddgi/surfel_ends.h"
#include "ddgi/surfel_marks.h"
#include "ddgi/surfel_queue.h"
#include "ddgi/surfels.h"
#include "scenes/ray_tracer.h"

namespace plumbline::ddgi {

/// The surfels of all probes, traced and lit again only where the world changed, which MotionMarker
/// tells.
///
/// After every call the surfels are the ones that tracing all of them afresh would give; with a
/// budget, all but those that wait, which are as they were before something touched them.
///
/// Where surfels share light, `direct` is that of each surfel's source, and `seen` is meaningful at
/// sources alone.
class SurfelCache {
 public:
    /// With ProbeWeights::Visibility surfels know which probes around them they see. At most
    /// `budget` surfels are re-placed or lit again by a refresh(), see SurfelQueue; none: all.
    /// Surfels share light in cells `share` spacings wide, see SurfelCells; 0: each has its own.
    SurfelCache(const ProbeGrid& grid, RayPattern pattern, Reach reach,
                ProbeWeights weights = ProbeWeights::None, std::optional<int> budget = std::nullopt,
                double share = 0.);

    /// Places and lights every surfel.
    void rebuild(const RayTracer& tracer);
    /// Places and lights those that `motion` touches, or those whose turn it is; `motion` leads
    /// from the world of the last call to that of `tracer`.
    void refresh(const RayTracer& tracer, const Motion& motion);

    const Surfels& surfels() const { return surfels_; }
    const RayPattern& pattern() const { return pattern_; }
    const ProbeGrid& grid() const { return grid_; }
    /// Whether the last call placed this surfel.
    bool replaced(std::size_t surfel) const { return (marks_.of(surfel) & Mark::Placed) != 0; }
    /// Whether the last call may have changed which probes it sees.
    bool sees_others(std::size_t surfel) const { return (marks_.of(surfel) & Mark::Seen) != 0; }
    /// Whether the last call may have changed anything of this surfel.
    bool changed(std::size_t surfel) const { return marks_.of(surfel) != 0; }
    /// ... or of any of this probe's.
    bool probe_changed(std::size_t probe) const { return marks_.of_probe(probe) != 0; }
    /// Calls f(surfel) for those surfels of a probe of which the last call may have changed
    /// anything.
    template <typename Function>
    void for_changed(std::size_t probe, const Function& f) const {
        marks_.for_rays(probe, any_mark, f);
    }
    /// How many surfels are on a surface.
    std::uint64_t hits() const { return hits_; }
    /// How many of these light is measured at.
    std::uint64_t lit() const { return cells_ ? sources_ : hits_; }
    /// How many wait for their turn.
    std::uint64_t waiting() const { return queue_ ? queue_->waiting() : 0; }
    /// Calls of refresh() since the oldest of these was touched, that one included.
    int oldest_wait() const { return queue_ ? queue_->oldest() : 0; }

    /// What the last call did, and what it took.
    struct Figures {
        StepTimes steps;  ///< all but what a model does
        std::uint64_t replaced = 0;
        std::uint64_t shadow_rays = 0;
        std::uint64_t traced = 0;  ///< rays that told which surfels are to be re-placed
    };
    const Figures& figures() const { return figures_; }

 private:
    struct Thread;
    struct Points;

    void take_planes(const World& world);
    void renew(const RayTracer& tracer, bool unless_there);
    template <typename Round>
    void in_rounds(const Round& round);
    void place(const RayTracer& tracer, bool unless_there, Thread& thread);
    void see(const RayTracer& tracer, Thread& thread);
    void light(const RayTracer& tracer, Thread& thread);
    void put(const SurfelEnds& ends, std::size_t i, std::size_t surfel);
    void find_points(Mark::Bit mark, Thread& thread) const;
    void leave_to_sources();
    void share_light();
    void spread_light();
    bool renewed(std::size_t surfel) const {
        return (marks_.of(surfel) & (Mark::Placed | Mark::Sourced)) != 0;
    }

    ProbeGrid grid_;
    RayPattern pattern_;
    Surfels surfels_;
    MotionMarker marker_;
    SurfelMarks marks_;
    std::optional<SurfelQueue> queue_;
    std::optional<SurfelCells> cells_;
    std::optional<CellPlanes> planes_;    ///< of the world of the last call; none: nobody sees
    std::uint64_t sources_ = 0;           ///< surfels that others, or they alone, show the light of
    std::vector<std::uint32_t> hits_of_;  ///< one a probe
    std::uint64_t hits_ = 0;
    Figures figures_;
};

}  // namespace plumbline::ddgi
