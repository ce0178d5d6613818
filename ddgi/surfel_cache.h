// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ddgi/grid.h"
#include "ddgi/motion.h"
#include "ddgi/moved_rays.h"
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
    bool replaced(std::size_t surfel) const { return (marks_[surfel] & Placed) != 0; }
    /// Whether the last call may have changed which probes it sees.
    bool sees_others(std::size_t surfel) const { return (marks_[surfel] & Seen) != 0; }
    /// Whether the last call may have changed anything of this surfel.
    bool changed(std::size_t surfel) const { return marks_[surfel] != 0; }
    /// ... or of any of this probe's.
    bool probe_changed(std::size_t probe) const { return probe_marks_[probe] != 0; }
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
    /// What is to be done to a surfel, or was done by the last call.
    enum Mark : std::uint8_t { Placed = 1, Lit = 2, Seen = 4 };

    struct Points {
        std::vector<std::size_t> surfel;
        std::vector<glm::vec3> position;
        std::vector<glm::vec3> n;
    };

    std::span<std::uint8_t> marks_of(std::size_t probe);
    void forget_marks();
    void mark_touched(const World& world, const Motion& motion);
    void mark_near(const Motion& motion);
    void mark_shadows(const World& world, const Motion& motion);
    bool touched(const RayTracer& movers, const Motion& motion, const glm::vec3& origin,
                 std::size_t surfel) const;
    bool within_reach(const Motion& motion, const glm::vec3& probe) const;
    std::vector<std::uint8_t> moved_cells(const Motion& motion) const;
    std::uint32_t cell_of(std::size_t surfel) const;
    std::uint32_t no_cell() const { return probe_count(grid_); }         ///< of misses
    std::uint32_t outer_cell() const { return probe_count(grid_) + 1; }  ///< all outside the grid
    bool is_at(const Hit& hit, const World& world, std::size_t surfel) const;

    void place_marked(const RayTracer& tracer);
    void see_marked(const RayTracer& tracer);
    void light_marked(const RayTracer& tracer);
    void place(const RayTracer& tracer, const glm::vec3& origin, std::size_t probe,
               std::size_t ray);
    void put_hit(const World& world, std::size_t surfel, const std::optional<Hit>& hit);
    float ray_length(const glm::vec3& direction) const;
    Points on_surfaces(std::span<const std::size_t> surfels) const;
    template <typename Body>
    void for_marked(Mark mark, const Body& body) const;

    ProbeGrid grid_;
    RayPattern pattern_;
    Reach reach_;
    Surfels surfels_;
    ProbeRays rays_;
    std::vector<std::uint32_t> cell_;  ///< see cell_of(); empty if nobody asks for seen probes
    std::vector<std::uint8_t> marks_;  ///< sets of Mark, one a surfel
    std::vector<std::uint8_t> probe_marks_;  ///< their union, one a probe
    std::vector<std::uint32_t> hits_of_;     ///< one a probe
    std::uint64_t hits_ = 0;
    Figures figures_;
};

}  // namespace plumbline::ddgi
