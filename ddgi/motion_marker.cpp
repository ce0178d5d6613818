// SPDX-License-Identifier: Apache-2.0
#include "ddgi/motion_marker.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "ddgi/grid_cell.h"
#include "ddgi/seen_probes.h"
#include "ddgi/shaft.h"

namespace plumbline::ddgi {
namespace {

bool overlap(const Bounds& a, const Bounds& b) {
    return glm::all(glm::lessThanEqual(a.lower, b.upper)) &&
           glm::all(glm::lessThanEqual(b.lower, a.upper));
}

/// Whether `bounds` and `box` may overlap: they do along all of their own axes.
bool overlap(const Bounds& bounds, const OrientedBox& box) {
    const glm::vec3 middle = box.to_box((bounds.lower + bounds.upper) / 2.f);
    const Bounds& of_box = box.bounds;
    const glm::vec3 middle_of_box = (of_box.lower + of_box.upper) / 2.f;
    const glm::vec3 apart = middle - middle_of_box;
    const glm::mat3 world_axes = glm::transpose(box.axes);
    const glm::vec3 world_apart = box.axes * apart;
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(apart[axis]) >
                of_box.size()[axis] / 2.f + half_width(bounds, box.axes[axis]) ||
            std::abs(world_apart[axis]) >
                bounds.size()[axis] / 2.f + half_width(of_box, world_axes[axis])) {
            return false;
        }
    }
    return true;
}

/// Whether something may have moved in `bounds`: both kinds of boxes hold all that moved.
bool moved_in(const Motion& motion, const Bounds& bounds) {
    const auto overlaps = [&](const auto& box) { return overlap(bounds, box); };
    return std::ranges::any_of(motion.boxes, overlaps) &&
           std::ranges::any_of(motion.oriented_boxes, overlaps);
}

bool is_on_mover(const Surfels& surfels, const Motion& motion, std::size_t surfel) {
    const int object = surfels.object[surfel];
    return object >= 0 && motion.moved[static_cast<std::size_t>(object)];
}

}  // namespace

bool is_at(const Surfels& surfels, const World& world, std::size_t surfel,
           const std::optional<Hit>& hit) {
    if (!hit || !surfels.hit(surfel)) return !hit && !surfels.hit(surfel);
    const SurfelPlace& place = surfels.place[surfel];
    return place.distance == hit->t && surfels.object[surfel] == hit->object &&
           place.n == hit->n() && place.position == offset_origin(*hit, hit->n()) &&
           surfels.light[surfel].albedo == hit->albedo &&
           (surfels.emission.empty() ||
            surfels.emission[surfel] ==
                world.materials[static_cast<std::size_t>(hit->material)].emission);
}

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
                           surfels.place[surfel].distance * (1.f + distance_rounding)),
                  surfels.hit(surfel) ? &surfels.place[surfel].position : nullptr);
    if (!cell_.empty()) cell_[surfel] = cell_of(surfels, surfel);
}

/// Whether any ray of the probe can meet what moved: those of one cell only within a cell of it
/// [Dellson 2023, section 3.6].
bool MotionMarker::within_reach(const Motion& motion, const glm::vec3& probe) const {
    if (reach_ == Reach::FirstSurface) return true;
    return std::ranges::any_of(
        motion.boxes, [&](const Bounds& box) { return box.grown(grid_.spacing).contains(probe); });
}

/// Whether tracing the ray of a surfel that is on a mover, or meets the box of one, afresh could
/// give another end.
bool MotionMarker::touched(const Surfels& surfels, const RayTracer& movers, const Motion& motion,
                           const glm::vec3& origin, std::size_t surfel) const {
    const bool on_mover = is_on_mover(surfels, motion, surfel);
    const glm::vec3& direction = surfels.direction[surfel];
    // What moved to right where the ray ended may be met first or second: both must be asked.
    const float t_max =
        std::min(ray_length(direction), surfels.place[surfel].distance * (1.f + distance_rounding));
    const std::optional<Hit> hit = movers.intersect({origin, direction, t_max}, BackFaces::Cull);
    if (!on_mover) return hit.has_value();
    // An object that slides in the plane that was hit, such as a rising door, leaves its surfels as
    // they were: nothing at rest was nearer before, nor is now.
    return !is_at(surfels, movers.world(), surfel, hit);
}

void MotionMarker::mark_places(const Surfels& surfels, const Motion& motion,
                               SurfelMarks& marks) const {
    // Of surfels on each object; the first is of those that are on none.
    std::vector<std::uint8_t> on_object(motion.moved.size() + 1);
    std::ranges::transform(motion.moved, std::next(on_object.begin()), [](bool moved) {
        return moved ? std::uint8_t{Mark::Placed} : std::uint8_t{0};
    });
    for_probes(marks.probes(), [&](std::size_t probe) {
        const glm::vec3 origin = probe_position(grid_, static_cast<std::uint32_t>(probe));
        if (!within_reach(motion, origin)) return;
        const std::span<std::uint8_t> of_rays = marks.rays_of(probe);
        for (const MovedBox& mover : motion.now) {
            if (mover.inside.bounds.contains(mover.inside.to_box(origin))) continue;
            rays_.mark_rays(probe, origin, mover.box, Mark::Placed, of_rays);
        }
        const int* objects = &surfels.object[probe * of_rays.size()];
        for (std::size_t ray = 0; ray < of_rays.size(); ++ray) {
            const auto object = static_cast<std::size_t>(std::int64_t{objects[ray]} + 1);
            of_rays[ray] = static_cast<std::uint8_t>(of_rays[ray] | on_object[object]);
        }
        marks.join(probe);
    });
}

void MotionMarker::confirm_places(const Surfels& surfels, const World& world, const Motion& motion,
                                  SurfelMarks& marks) const {
    const World movers = moved_part(world, motion);
    const RayTracer movers_tracer(movers);
    for_probes(marks.probes(), [&](std::size_t probe) {
        if ((marks.of_probe(probe) & Mark::Placed) == 0) return;
        const glm::vec3 origin = probe_position(grid_, static_cast<std::uint32_t>(probe));
        const std::span<std::uint8_t> of_rays = marks.rays_of(probe);
        for (std::size_t ray = 0; ray < of_rays.size(); ++ray) {
            if ((of_rays[ray] & Mark::Placed) == 0) continue;
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
    const glm::vec3& x = surfels.place[surfel].position;
    const glm::vec3 last = grid_.origin + grid_.spacing * glm::vec3(grid_.counts - 1);
    return Bounds{grid_.origin, last}.contains(x) ? cell_probe(grid_, x) : outer_cell();
}

/// Of each cell what its surfels are marked with: Mark::Seen if something may have moved in it; the
/// outer cell is not asked for.
std::vector<std::uint8_t> MotionMarker::moved_cells(const Motion& motion) const {
    std::vector<std::uint8_t> marks(outer_cell() + 1);
    for (const Bounds& box : motion.boxes) {
        const Bounds near = box.grown(2.f * in_surface * grid_.spacing);
        const glm::ivec3 first = cell_around(grid_, place_in(grid_, near.lower));
        const glm::ivec3 last = cell_around(grid_, place_in(grid_, near.upper));
        for (int y = first.y; y <= last.y; ++y) {
            for (int x = first.x; x <= last.x; ++x) {
                for (int z = first.z; z <= last.z; ++z) {
                    const std::uint32_t cell = probe_index(grid_, {x, y, z});
                    const glm::vec3 middle = probe_position(grid_, cell) + grid_.spacing / 2.f;
                    if (moved_in(motion, bounds_to_probes(grid_, middle))) marks[cell] = Mark::Seen;
                }
            }
        }
    }
    return marks;
}

void MotionMarker::mark_near(const Surfels& surfels, const Motion& motion,
                             SurfelMarks& marks) const {
    if (cell_.empty()) return;
    constexpr std::uint8_t ask = 0x80;  // no Mark
    std::vector<std::uint8_t> mark_of = moved_cells(motion);
    mark_of[outer_cell()] = ask;
    for_probes(marks.probes(), [&](std::size_t probe) {
        const std::span<std::uint8_t> of_rays = marks.rays_of(probe);
        const std::uint32_t* cells = &cell_[probe * of_rays.size()];
        std::uint8_t all = 0;
        for (std::size_t ray = 0; ray < of_rays.size(); ++ray) {
            const std::uint8_t mark = mark_of[cells[ray]];
            all |= mark;
            of_rays[ray] = static_cast<std::uint8_t>(of_rays[ray] | (mark & Mark::Seen));
        }
        for (std::size_t ray = 0; (all & ask) != 0 && ray < of_rays.size(); ++ray) {
            if (cells[ray] != outer_cell()) continue;
            const glm::vec3& x = surfels.place[probe * of_rays.size() + ray].position;
            if (moved_in(motion, bounds_to_probes(grid_, x))) of_rays[ray] |= Mark::Seen;
        }
        if (all != 0) marks.join(probe);
    });
}

/// Whether the light of a surfel of `probe` may have changed by what moved: it did not where
/// nothing is on any way, or one solid box was on all ways and still is. Told of surfels less than
/// a cell away only, as others may be anywhere.
bool MotionMarker::may_reach_shadows(const Motion& motion, const LampWay& light,
                                     std::size_t probe) const {
    if (reach_ == Reach::FirstSurface) return true;
    // Surfels stand off their surfaces by rounding.
    constexpr float margin = 1e-3f;
    const float reach = (1.f + margin) * grid_.spacing;
    const glm::vec3 middle = probe_position(grid_, static_cast<std::uint32_t>(probe));
    const bool met = std::ranges::any_of(motion.oriented_boxes, [&](const OrientedBox& box) {
        return Shaft(light, box, middle, reach).may_meet(box.bounds.grown(light.radius));
    });
    return met && std::ranges::none_of(light.solids, [&](const SolidMove& solid) {
               return Shaft(light, solid.was, middle, reach).all_meet(solid.was.bounds) &&
                      Shaft(light, solid.is, middle, reach).all_meet(solid.is.bounds);
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
            if (!may_reach_shadows(motion, way, probe)) continue;
            rays_.mark_shadows(probe, way, motion.oriented_boxes, Mark::Lit, of_rays);
        }
        marks.join(probe);
    });
}

}  // namespace plumbline::ddgi
