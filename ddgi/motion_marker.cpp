// SPDX-License-Identifier: Apache-2.0
#include "ddgi/motion_marker.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "ddgi/seen_probes.h"

namespace plumbline::ddgi {
namespace {

/// Well above the relative rounding of distances, well below what moves in a frame.
constexpr float distance_rounding = 1e-5f;

bool overlap(const Bounds& a, const Bounds& b) {
    return glm::all(glm::lessThanEqual(a.lower, b.upper)) &&
           glm::all(glm::lessThanEqual(b.lower, a.upper));
}

/// Whether placing the surfel at `hit` would change nothing of it.
bool is_at(const Surfels& surfels, const Hit& hit, const World& world, std::size_t surfel) {
    return surfels.distance[surfel] == hit.t && surfels.object[surfel] == hit.object &&
           surfels.n[surfel] == hit.n() &&
           surfels.position[surfel] == offset_origin(hit, hit.n()) &&
           surfels.albedo[surfel] == hit.albedo &&
           surfels.emission[surfel] ==
               world.materials[static_cast<std::size_t>(hit.material)].emission;
}

}  // namespace

MotionMarker::MotionMarker(const ProbeGrid& grid, Reach reach, const Surfels& surfels, bool sees)
    : grid_(grid),
      reach_(reach),
      rays_(probe_count(grid), static_cast<std::size_t>(surfels.per_probe)) {
    if (sees) cell_.resize(surfels.size());
    const auto per_probe = static_cast<std::size_t>(surfels.per_probe);
    for_probes(probe_count(grid), [&](std::size_t probe) {
        for (std::size_t ray = 0; ray < per_probe; ++ray) {
            rays_.set_direction(probe, ray, surfels.direction[probe * per_probe + ray]);
        }
    });
}

float MotionMarker::ray_length(const glm::vec3& direction) const {
    if (reach_ == Reach::FirstSurface) return std::numeric_limits<float>::infinity();
    return grid_.spacing / max_component(glm::abs(direction));
}

void MotionMarker::note_end(const Surfels& surfels, std::size_t probe, std::size_t ray) {
    const std::size_t surfel = probe * static_cast<std::size_t>(surfels.per_probe) + ray;
    rays_.set_end(probe, ray,
                  std::min(ray_length(surfels.direction[surfel]),
                           surfels.distance[surfel] * (1.f + distance_rounding)),
                  surfels.hit(surfel) ? &surfels.position[surfel] : nullptr);
    if (!cell_.empty()) cell_[surfel] = cell_of(surfels, surfel);
}

/// Whether any ray of the probe can meet what moved: those of one cell only within a cell of it
/// [Dellson 2023, section 3.6].
bool MotionMarker::within_reach(const Motion& motion, const glm::vec3& probe) const {
    if (reach_ == Reach::FirstSurface) return true;
    return std::ranges::any_of(
        motion.boxes, [&](const Bounds& box) { return box.grown(grid_.spacing).contains(probe); });
}

/// Whether tracing the ray of a surfel that meets a moved box afresh could give another end.
bool MotionMarker::touched(const Surfels& surfels, const RayTracer& movers, const Motion& motion,
                           const glm::vec3& origin, std::size_t surfel) const {
    const int object = surfels.object[surfel];
    const bool on_mover = object >= 0 && motion.moved[static_cast<std::size_t>(object)];
    const glm::vec3& direction = surfels.direction[surfel];
    // What moved to right where the ray ended may be met first or second: both must be asked.
    const float t_max =
        std::min(ray_length(direction), surfels.distance[surfel] * (1.f + distance_rounding));
    const std::optional<Hit> hit = movers.intersect({origin, direction, t_max}, BackFaces::Cull);
    if (!on_mover) return hit.has_value();
    // An object that slides in the plane that was hit, such as a rising door, leaves its surfels as
    // they were: nothing at rest was nearer before, nor is now.
    return !hit || !is_at(surfels, *hit, movers.world(), surfel);
}

void MotionMarker::mark_places(const Surfels& surfels, const World& world, const Motion& motion,
                               SurfelMarks& marks) const {
    const World movers = moved_part(world, motion);
    const RayTracer movers_tracer(movers);
    for_probes(marks.probes(), [&](std::size_t probe) {
        const glm::vec3 origin = probe_position(grid_, static_cast<std::uint32_t>(probe));
        if (!within_reach(motion, origin)) return;
        const std::span<std::uint8_t> of_rays = marks.rays_of(probe);
        for (const OrientedBox& box : motion.oriented_boxes) {
            rays_.mark_rays(probe, origin, box, Mark::Placed, of_rays);
        }
        for (std::size_t ray = 0; ray < of_rays.size(); ++ray) {
            if (of_rays[ray] == 0) continue;
            const std::size_t surfel = probe * of_rays.size() + ray;
            const bool place = touched(surfels, movers_tracer, motion, origin, surfel);
            of_rays[ray] = place ? all_marks : std::uint8_t{0};
        }
        marks.join(probe);
    });
}

/// The cell that a surfel is in, named by its lowest probe, or one of the two names that are no
/// probe's.
std::uint32_t MotionMarker::cell_of(const Surfels& surfels, std::size_t surfel) const {
    if (!surfels.hit(surfel)) return no_cell();
    const glm::vec3& x = surfels.position[surfel];
    const glm::vec3 last = grid_.origin + grid_.spacing * glm::vec3(grid_.counts - 1);
    return Bounds{grid_.origin, last}.contains(x) ? cell_probe(grid_, x) : outer_cell();
}

/// Of each cell whether something moved in it, or for the outer cell may have.
std::vector<std::uint8_t> MotionMarker::moved_cells(const Motion& motion) const {
    std::vector<std::uint8_t> moved(outer_cell() + 1);
    for_probes(probe_count(grid_), [&](std::size_t probe) {
        const glm::vec3 middle =
            probe_position(grid_, static_cast<std::uint32_t>(probe)) + grid_.spacing / 2.f;
        const Bounds bounds = bounds_to_probes(grid_, middle);
        moved[probe] = std::ranges::any_of(motion.boxes,
                                           [&](const Bounds& box) { return overlap(box, bounds); });
    });
    moved[outer_cell()] = 1;
    return moved;
}

void MotionMarker::mark_near(const Surfels& surfels, const Motion& motion,
                             SurfelMarks& marks) const {
    if (cell_.empty()) return;
    const std::vector<std::uint8_t> moved = moved_cells(motion);
    const auto moved_near = [&](std::size_t surfel) {
        if (moved[cell_[surfel]] == 0) return false;
        const Bounds bounds = bounds_to_probes(grid_, surfels.position[surfel]);
        return std::ranges::any_of(motion.boxes,
                                   [&](const Bounds& box) { return overlap(box, bounds); });
    };
    for_probes(marks.probes(), [&](std::size_t probe) {
        const std::span<std::uint8_t> of_rays = marks.rays_of(probe);
        for (std::size_t ray = 0; ray < of_rays.size(); ++ray) {
            if (moved_near(probe * of_rays.size() + ray)) of_rays[ray] |= Mark::Seen;
        }
        marks.join(probe);
    });
}

void MotionMarker::mark_shadows(const Surfels& surfels, const World& world, const Motion& motion,
                                std::span<const std::uint32_t> hits, SurfelMarks& marks) const {
    const std::vector<LampWay> ways = lamp_ways(world, motion);
    for_probes(marks.probes(), [&](std::size_t probe) {
        if (hits[probe] == 0) return;
        const std::span<std::uint8_t> of_rays = marks.rays_of(probe);
        if (motion.lights) {
            for (std::size_t ray = 0; ray < of_rays.size(); ++ray) {
                if (surfels.hit(probe * of_rays.size() + ray)) of_rays[ray] |= Mark::Lit;
            }
        }
        for (const LampWay& way : ways) {
            rays_.mark_shadows(probe, way, motion.oriented_boxes, Mark::Lit, of_rays);
        }
        marks.join(probe);
    });
}

}  // namespace plumbline::ddgi
