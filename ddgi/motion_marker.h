// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "ddgi/grid.h"
#include "ddgi/motion.h"
#include "ddgi/moved_rays.h"
#include "ddgi/surfel_marks.h"
#include "ddgi/surfels.h"
#include "scenes/ray_tracer.h"

namespace plumbline::ddgi {

/// How far surfel rays go, and so which of them a moved object can touch.
enum class Reach {
    OneCell,       ///< one cell along each axis [Dellson 2023, section 3.3]
    FirstSurface,  ///< as far as it takes
};

/// Tells which surfels a motion touches.
///
/// A surfel is to be placed if its ray meets a moved object before where it ended, or if it was on
/// a moved object that it no longer meets at the very same point. [Dellson 2023, section 3.6]
/// re-places all surfels of a probe that lies within a cell of a moved object's box.
///
/// Placing a surfel tells by itself whether its ray ends where it did, see is_at(); where others
/// wait for the turn that it takes, that is asked first.
class MotionMarker {
 public:
    /// `directions`: of all surfels. `sees`: surfels know which probes around them they see.
    MotionMarker(const ProbeGrid& grid, Reach reach, const Surfels& surfels, bool sees);

    /// How far a probe's ray goes: to the first surface, or one cell along its longest axis.
    float ray_length(const glm::vec3& direction) const;
    /// Takes in where ray `ray` of `probe` ends now.
    void note_end(const Surfels& surfels, std::size_t probe, std::size_t ray);

    /// Marks those whose rays may end elsewhere as Placed: a few more than do.
    void mark_places(const Surfels& surfels, const Motion& motion, SurfelMarks& marks) const;
    /// Looks again, by the rays themselves, at those that are marked as Placed, and marks those
    /// that something touched with all there is.
    void confirm_places(const Surfels& surfels, const World& world, const Motion& motion,
                        SurfelMarks& marks) const;
    /// Marks those between which and the probes around them something moved as Seen.
    void mark_near(const Surfels& surfels, const Motion& motion, SurfelMarks& marks) const;
    /// Marks those whose light may have changed, something moved on the way or the lights did, as
    /// Lit. `hits`: of each probe, how many of its surfels are on a surface.
    void mark_shadows(const Surfels& surfels, const World& world, const Motion& motion,
                      std::span<const std::uint32_t> hits, SurfelMarks& marks) const;

 private:
    bool within_reach(const Motion& motion, const glm::vec3& probe) const;
    bool touched(const Surfels& surfels, const RayTracer& movers, const Motion& motion,
                 const glm::vec3& origin, std::size_t surfel) const;
    bool may_reach_shadows(const Motion& motion, const LampWay& light, std::size_t probe) const;
    std::vector<std::uint8_t> moved_cells(const Motion& motion) const;
    std::uint32_t cell_of(const Surfels& surfels, std::size_t surfel) const;
    std::uint32_t no_cell() const { return probe_count(grid_); }         ///< of misses
    std::uint32_t outer_cell() const { return probe_count(grid_) + 1; }  ///< all outside the grid

    ProbeGrid grid_;
    Reach reach_;
    ProbeRays rays_;
    std::vector<std::uint32_t> cell_;  ///< see cell_of(); empty if nobody asks for seen probes
};

/// Whether placing the surfel at `hit`, or as a miss if there is none, would change nothing of it.
bool is_at(const Surfels& surfels, const World& world, std::size_t surfel,
           const std::optional<Hit>& hit);

}  // namespace plumbline::ddgi
