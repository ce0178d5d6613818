// SPDX-License-Identifier: Apache-2.0
#include "ddgi/surfel_cache.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <numeric>
#include <utility>

#include "ddgi/direct_light.h"
#include "ddgi/stopwatch.h"

namespace plumbline::ddgi {
namespace {

/// Well above the relative rounding of distances, well below what moves in a frame.
constexpr float distance_rounding = 1e-5f;

bool overlap(const Bounds& a, const Bounds& b) {
    return glm::all(glm::lessThanEqual(a.lower, b.upper)) &&
           glm::all(glm::lessThanEqual(b.lower, a.upper));
}

/// Calls body(probe) for each probe, in parallel.
template <typename Body>
void for_probes(std::size_t probes, const Body& body) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, probes),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                          for (std::size_t i = range.begin(); i < range.end(); ++i) body(i);
                      });
}

std::uint8_t all_of(std::span<const std::uint8_t> marks) {
    return std::reduce(marks.begin(), marks.end(), std::uint8_t{0}, std::bit_or<std::uint8_t>());
}

}  // namespace

SurfelCache::SurfelCache(const ProbeGrid& grid, RayPattern pattern, Reach reach,
                         ProbeWeights weights)
    : grid_(grid),
      pattern_(std::move(pattern)),
      reach_(reach),
      rays_(probe_count(grid), static_cast<std::size_t>(pattern_.size())) {
    surfels_.resize(probe_count(grid), pattern_.size());
    if (weights == ProbeWeights::Visibility) {
        surfels_.seen.resize(surfels_.size());
        cell_.resize(surfels_.size());
    }
    for_probes(probe_count(grid), [&](std::size_t probe) {
        const auto directions =
            probe_directions(pattern_, probe_cell(grid_, static_cast<std::uint32_t>(probe)));
        for (std::size_t ray = 0; ray < directions.size(); ++ray) {
            surfels_.direction[probe * directions.size() + ray] = directions[ray];
            rays_.set_direction(probe, ray, directions[ray]);
        }
    });
    marks_.resize(surfels_.size());
    probe_marks_.resize(probe_count(grid));
    hits_of_.resize(probe_count(grid));
}

void SurfelCache::rebuild(const RayTracer& tracer) {
    figures_ = {};
    std::ranges::fill(marks_, std::uint8_t{Placed | Lit | Seen});
    std::ranges::fill(probe_marks_, std::uint8_t{Placed | Lit | Seen});
    place_marked(tracer);
    see_marked(tracer);
    light_marked(tracer);
}

void SurfelCache::refresh(const RayTracer& tracer, const Motion& motion) {
    figures_ = {};
    forget_marks();
    if (motion.none()) return;
    const Stopwatch watch;
    mark_touched(tracer.world(), motion);
    figures_.place_ms = watch.ms();
    place_marked(tracer);
    const Stopwatch seeing;
    mark_near(motion);
    figures_.place_ms += seeing.ms();
    see_marked(tracer);
    const Stopwatch lighting;
    mark_shadows(tracer.world(), motion);
    figures_.light_ms = lighting.ms();
    light_marked(tracer);
    for_probes(probe_marks_.size(), [&](std::size_t probe) {
        if (probe_marks_[probe] != 0) probe_marks_[probe] = all_of(marks_of(probe));
    });
}

std::span<std::uint8_t> SurfelCache::marks_of(std::size_t probe) {
    const auto per_probe = static_cast<std::size_t>(surfels_.per_probe);
    return {&marks_[probe * per_probe], per_probe};
}

void SurfelCache::forget_marks() {
    for_probes(probe_marks_.size(), [&](std::size_t probe) {
        if (probe_marks_[probe] == 0) return;
        std::ranges::fill(marks_of(probe), std::uint8_t{0});
        probe_marks_[probe] = 0;
    });
}

/// Calls body(surfels) with batches of the surfels that have this mark, in parallel.
template <typename Body>
void SurfelCache::for_marked(Mark mark, const Body& body) const {
    constexpr std::size_t most_at_once = 256;
    const auto per_probe = static_cast<std::size_t>(surfels_.per_probe);
    const tbb::blocked_range<std::size_t> probes(0, probe_marks_.size());
    tbb::parallel_for(probes, [&](const tbb::blocked_range<std::size_t>& range) {
        std::vector<std::size_t> batch;
        for (std::size_t probe = range.begin(); probe < range.end(); ++probe) {
            if ((probe_marks_[probe] & mark) == 0) continue;
            for (std::size_t i = probe * per_probe; i < (probe + 1) * per_probe; ++i) {
                if ((marks_[i] & mark) != 0) batch.push_back(i);
            }
            if (batch.size() < most_at_once) continue;
            body(std::span<const std::size_t>(batch));
            batch.clear();
        }
        if (!batch.empty()) body(std::span<const std::size_t>(batch));
    });
}

/// How far a probe's ray goes: to the first surface, or one cell along its longest axis.
float SurfelCache::ray_length(const glm::vec3& direction) const {
    if (reach_ == Reach::FirstSurface) return std::numeric_limits<float>::infinity();
    return grid_.spacing / max_component(glm::abs(direction));
}

/// Whether any ray of the probe can meet what moved: those of one cell only within a cell of it
/// [Dellson 2023, section 3.6].
bool SurfelCache::within_reach(const Motion& motion, const glm::vec3& probe) const {
    if (reach_ == Reach::FirstSurface) return true;
    return std::ranges::any_of(
        motion.boxes, [&](const Bounds& box) { return box.grown(grid_.spacing).contains(probe); });
}

/// Whether tracing the ray of a surfel that meets a moved box afresh could give another end.
bool SurfelCache::touched(const RayTracer& movers, const Motion& motion, const glm::vec3& origin,
                          std::size_t surfel) const {
    const int object = surfels_.object[surfel];
    const bool on_mover = object >= 0 && motion.moved[static_cast<std::size_t>(object)];
    const glm::vec3& direction = surfels_.direction[surfel];
    // What moved to right where the ray ended may be met first or second: both must be asked.
    const float t_max =
        std::min(ray_length(direction), surfels_.distance[surfel] * (1.f + distance_rounding));
    const std::optional<Hit> hit = movers.intersect({origin, direction, t_max}, BackFaces::Cull);
    if (!on_mover) return hit.has_value();
    // An object that slides in the plane that was hit, such as a rising door, leaves its surfels as
    // they were: nothing at rest was nearer before, nor is now.
    return !hit || !is_at(*hit, movers.world(), surfel);
}

/// Whether placing the surfel at `hit` would change nothing of it.
bool SurfelCache::is_at(const Hit& hit, const World& world, std::size_t surfel) const {
    return surfels_.distance[surfel] == hit.t && surfels_.object[surfel] == hit.object &&
           surfels_.n[surfel] == hit.n() &&
           surfels_.position[surfel] == offset_origin(hit, hit.n()) &&
           surfels_.albedo[surfel] == hit.albedo &&
           surfels_.emission[surfel] ==
               world.materials[static_cast<std::size_t>(hit.material)].emission;
}

void SurfelCache::mark_touched(const World& world, const Motion& motion) {
    const World movers = moved_part(world, motion);
    const RayTracer movers_tracer(movers);
    const auto per_probe = static_cast<std::size_t>(surfels_.per_probe);
    for_probes(probe_marks_.size(), [&](std::size_t probe) {
        const glm::vec3 origin = probe_position(grid_, static_cast<std::uint32_t>(probe));
        if (!within_reach(motion, origin)) return;
        const std::span<std::uint8_t> marks = marks_of(probe);
        for (const OrientedBox& box : motion.oriented_boxes) {
            rays_.mark_rays(probe, origin, box, Placed, marks);
        }
        if (all_of(marks) == 0) return;
        for (std::size_t ray = 0; ray < per_probe; ++ray) {
            if (marks[ray] == 0) continue;
            const bool place = touched(movers_tracer, motion, origin, probe * per_probe + ray);
            marks[ray] = place ? Placed | Lit | Seen : 0;
        }
        probe_marks_[probe] = all_of(marks);
    });
}

void SurfelCache::place_marked(const RayTracer& tracer) {
    const Stopwatch watch;
    std::atomic<std::uint64_t> replaced{0};
    const auto per_probe = static_cast<std::size_t>(surfels_.per_probe);
    for_probes(probe_marks_.size(), [&](std::size_t probe) {
        if ((probe_marks_[probe] & Placed) == 0) return;
        const glm::vec3 origin = probe_position(grid_, static_cast<std::uint32_t>(probe));
        const std::span<const std::uint8_t> marks = marks_of(probe);
        std::uint64_t placed = 0;
        for (std::size_t ray = 0; ray < per_probe; ++ray) {
            if ((marks[ray] & Placed) == 0) continue;
            const std::size_t surfel = probe * per_probe + ray;
            hits_of_[probe] -= surfels_.hit(surfel) ? 1u : 0u;
            place(tracer, origin, probe, ray);
            hits_of_[probe] += surfels_.hit(surfel) ? 1u : 0u;
            ++placed;
        }
        replaced += placed;
    });
    figures_.replaced = replaced;
    hits_ = std::reduce(hits_of_.begin(), hits_of_.end(), std::uint64_t{0});
    figures_.place_ms += watch.ms();
}

void SurfelCache::place(const RayTracer& tracer, const glm::vec3& origin, std::size_t probe,
                        std::size_t ray) {
    const std::size_t surfel = probe * static_cast<std::size_t>(surfels_.per_probe) + ray;
    const glm::vec3& direction = surfels_.direction[surfel];
    const float length = ray_length(direction);
    put_hit(tracer.world(), surfel, tracer.intersect({origin, direction, length}, BackFaces::Cull));
    rays_.set_end(probe, ray,
                  std::min(length, surfels_.distance[surfel] * (1.f + distance_rounding)),
                  surfels_.hit(surfel) ? &surfels_.position[surfel] : nullptr);
    if (!cell_.empty()) cell_[surfel] = cell_of(surfel);
}

void SurfelCache::put_hit(const World& world, std::size_t surfel, const std::optional<Hit>& hit) {
    if (!hit) {
        surfels_.distance[surfel] = std::numeric_limits<float>::infinity();
        surfels_.emission[surfel] = environment_radiance(world, surfels_.direction[surfel]);
        surfels_.object[surfel] = -1;
        return;
    }
    surfels_.distance[surfel] = hit->t;
    surfels_.position[surfel] = offset_origin(*hit, hit->n());
    surfels_.n[surfel] = hit->n();
    surfels_.object[surfel] = hit->object;
    surfels_.albedo[surfel] = hit->albedo;
    surfels_.emission[surfel] = world.materials[static_cast<std::size_t>(hit->material)].emission;
}

/// The cell that a surfel is in, named by its lowest probe, or one of the two names that are no
/// probe's.
std::uint32_t SurfelCache::cell_of(std::size_t surfel) const {
    if (!surfels_.hit(surfel)) return no_cell();
    const glm::vec3& x = surfels_.position[surfel];
    const glm::vec3 last = grid_.origin + grid_.spacing * glm::vec3(grid_.counts - 1);
    return Bounds{grid_.origin, last}.contains(x) ? cell_probe(grid_, x) : outer_cell();
}

/// Of each cell whether something moved in it, or for the outer cell may have.
std::vector<std::uint8_t> SurfelCache::moved_cells(const Motion& motion) const {
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

/// Marks those between which and the probes around them something moved.
void SurfelCache::mark_near(const Motion& motion) {
    if (surfels_.seen.empty()) return;
    const std::vector<std::uint8_t> moved = moved_cells(motion);
    const auto moved_near = [&](std::size_t surfel) {
        if (moved[cell_[surfel]] == 0) return false;
        const Bounds bounds = bounds_to_probes(grid_, surfels_.position[surfel]);
        return std::ranges::any_of(motion.boxes,
                                   [&](const Bounds& box) { return overlap(box, bounds); });
    };
    const auto per_probe = static_cast<std::size_t>(surfels_.per_probe);
    for_probes(probe_marks_.size(), [&](std::size_t probe) {
        const std::span<std::uint8_t> marks = marks_of(probe);
        for (std::size_t ray = 0; ray < per_probe; ++ray) {
            if (moved_near(probe * per_probe + ray)) marks[ray] |= Seen;
        }
        probe_marks_[probe] = all_of(marks);
    });
}

/// Those of `surfels` that are on a surface, and where.
SurfelCache::Points SurfelCache::on_surfaces(std::span<const std::size_t> surfels) const {
    Points points;
    for (const std::size_t surfel : surfels) {
        if (!surfels_.hit(surfel)) continue;
        points.surfel.push_back(surfel);
        points.position.push_back(surfels_.position[surfel]);
        points.n.push_back(surfels_.n[surfel]);
    }
    return points;
}

void SurfelCache::see_marked(const RayTracer& tracer) {
    if (surfels_.seen.empty()) return;
    const Stopwatch watch;
    for_marked(Seen, [&](std::span<const std::size_t> batch) {
        const auto [surfels, x, n] = on_surfaces(batch);
        std::vector<std::uint8_t> seen(x.size());
        seen_probes(tracer, grid_, x, n, seen);
        for (std::size_t i = 0; i < seen.size(); ++i) {
            const std::size_t surfel = surfels[i];
            // What is as it was need not be looked at again.
            if (surfels_.seen[surfel] == seen[i] && !replaced(surfel)) marks_[surfel] &= ~Seen;
            surfels_.seen[surfel] = seen[i];
        }
    });
    figures_.place_ms += watch.ms();
}

/// Marks those whose light may have changed: something moved on the way, or the lights did.
void SurfelCache::mark_shadows(const World& world, const Motion& motion) {
    const std::vector<LampWay> ways = lamp_ways(world, motion);
    const auto per_probe = static_cast<std::size_t>(surfels_.per_probe);
    for_probes(probe_marks_.size(), [&](std::size_t probe) {
        if (hits_of_[probe] == 0) return;
        const std::span<std::uint8_t> marks = marks_of(probe);
        if (motion.lights) {
            for (std::size_t ray = 0; ray < per_probe; ++ray) {
                if (surfels_.hit(probe * per_probe + ray)) marks[ray] |= Lit;
            }
        }
        for (const LampWay& way : ways) {
            rays_.mark_shadows(probe, way, motion.oriented_boxes, Lit, marks);
        }
        probe_marks_[probe] = all_of(marks);
    });
}

void SurfelCache::light_marked(const RayTracer& tracer) {
    const Stopwatch watch;
    std::atomic<std::uint64_t> shadow_rays{0};
    for_marked(Lit, [&](std::span<const std::size_t> batch) {
        const auto [surfels, x, n] = on_surfaces(batch);
        std::vector<DirectLight> light(x.size());
        direct_light(tracer, x, n, light);
        std::uint64_t rays = 0;
        for (std::size_t i = 0; i < light.size(); ++i) {
            const std::size_t surfel = surfels[i];
            rays += light[i].shadow_rays;
            if (surfels_.direct[surfel] == light[i].irradiance && !replaced(surfel))
                marks_[surfel] &= ~Lit;
            surfels_.direct[surfel] = light[i].irradiance;
        }
        shadow_rays += rays;
    });
    figures_.shadow_rays = shadow_rays;
    figures_.light_ms += watch.ms();
}

}  // namespace plumbline::ddgi
