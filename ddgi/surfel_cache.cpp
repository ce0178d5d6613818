// SPDX-License-Identifier: Apache-2.0
#include "ddgi/surfel_cache.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <numeric>
#include <utility>

#include "ddgi/direct_light.h"
#include "ddgi/stopwatch.h"

namespace plumbline::ddgi {
namespace {

/// Surfels that know their rays, but not yet where these end.
Surfels unplaced(const ProbeGrid& grid, const RayPattern& pattern, bool sees) {
    Surfels surfels;
    surfels.resize(probe_count(grid), pattern.size());
    if (sees) surfels.seen.resize(surfels.size());
    for_probes(probe_count(grid), [&](std::size_t probe) {
        const auto directions =
            probe_directions(pattern, probe_cell(grid, static_cast<std::uint32_t>(probe)));
        std::ranges::copy(directions, &surfels.direction[probe * directions.size()]);
    });
    return surfels;
}

}  // namespace

SurfelCache::SurfelCache(const ProbeGrid& grid, RayPattern pattern, Reach reach,
                         ProbeWeights weights, std::optional<int> budget, double share)
    : grid_(grid),
      pattern_(std::move(pattern)),
      surfels_(unplaced(grid, pattern_, weights == ProbeWeights::Visibility)),
      marker_(grid, reach, surfels_, weights == ProbeWeights::Visibility),
      marks_(probe_count(grid), static_cast<std::size_t>(surfels_.per_probe)),
      hits_of_(probe_count(grid)) {
    if (budget) queue_.emplace(surfels_.size(), *budget);
    if (share > 0.) {
        cells_.emplace(share * double(grid.spacing), surfels_.size());
        surfels_.source.resize(surfels_.size());
    }
}

void SurfelCache::rebuild(const RayTracer& tracer) {
    figures_ = {};
    marks_.set_all();
    place_marked(tracer, false);
    share_light();
    see_marked(tracer);
    light_marked(tracer);
    spread_light();
}

void SurfelCache::refresh(const RayTracer& tracer, const Motion& motion) {
    figures_ = {};
    marks_.clear();
    if (!motion.none()) {
        const Stopwatch placing;
        marker_.mark_places(surfels_, motion, marks_);
        if (queue_) marker_.confirm_places(surfels_, tracer.world(), motion, marks_);
        marker_.mark_near(surfels_, motion, marks_);
        figures_.place_ms = placing.ms();
        const Stopwatch lighting;
        marker_.mark_shadows(surfels_, tracer.world(), motion, hits_of_, marks_);
        leave_to_sources();
        figures_.light_ms = lighting.ms();
    } else if (waiting() == 0) {
        return;
    }
    if (queue_) {
        const Stopwatch choosing;
        queue_->take_turn(marks_);
        figures_.place_ms += choosing.ms();
    }
    place_marked(tracer, true);
    share_light();
    see_marked(tracer);
    light_marked(tracer);
    spread_light();
    marks_.join();
}

/// With `unless_there` those whose rays end where they did stay as they are, and lose the mark.
void SurfelCache::place_marked(const RayTracer& tracer, bool unless_there) {
    const Stopwatch watch;
    std::atomic<std::uint64_t> traced{0}, replaced{0};
    for_probes(marks_.probes(), [&](std::size_t probe) {
        if ((marks_.of_probe(probe) & Mark::Placed) == 0) return;
        const glm::vec3 origin = probe_position(grid_, static_cast<std::uint32_t>(probe));
        const std::span<std::uint8_t> of_rays = marks_.rays_of(probe);
        std::uint64_t asked = 0, placed = 0;
        for (std::size_t ray = 0; ray < of_rays.size(); ++ray) {
            if ((of_rays[ray] & Mark::Placed) == 0) continue;
            const std::size_t surfel = probe * of_rays.size() + ray;
            ++asked;
            const glm::vec3& direction = surfels_.direction[surfel];
            const std::optional<Hit> hit = tracer.intersect(
                {origin, direction, marker_.ray_length(direction)}, BackFaces::Cull);
            if (unless_there && is_at(surfels_, tracer.world(), surfel, hit)) {
                marks_.drop(surfel, Mark::Placed);
                continue;
            }
            of_rays[ray] |= all_marks;
            hits_of_[probe] -= surfels_.hit(surfel) ? 1u : 0u;
            put_hit(tracer.world(), surfel, hit);
            hits_of_[probe] += surfels_.hit(surfel) ? 1u : 0u;
            marker_.note_end(surfels_, probe, ray);
            ++placed;
        }
        marks_.join(probe);
        traced += asked;
        replaced += placed;
    });
    figures_.traced = traced;
    figures_.replaced = replaced;
    hits_ = std::reduce(hits_of_.begin(), hits_of_.end(), std::uint64_t{0});
    figures_.place_ms += watch.ms();
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

/// Takes the marks back from those that show another's light, and stay where they are.
void SurfelCache::leave_to_sources() {
    if (!cells_) return;
    for_probes(marks_.probes(), [&](std::size_t probe) {
        if (marks_.of_probe(probe) == 0) return;
        const std::span<std::uint8_t> of_rays = marks_.rays_of(probe);
        for (std::size_t ray = 0; ray < of_rays.size(); ++ray) {
            const std::size_t surfel = probe * of_rays.size() + ray;
            if (!replaced(surfel) && !surfels_.own_light(surfel)) of_rays[ray] = 0;
        }
        marks_.join(probe);
    });
}

/// Groups the surfels anew if some were placed, and marks those to be lit that light was not
/// measured at before.
void SurfelCache::share_light() {
    if (!cells_ || figures_.replaced == 0) return;
    const Stopwatch watch;
    const std::vector<std::uint32_t> before = surfels_.source;
    sources_ = cells_->group(surfels_);
    for_probes(marks_.probes(), [&](std::size_t probe) {
        const std::size_t first = probe * marks_.per_probe();
        for (std::size_t i = first; i < first + marks_.per_probe(); ++i) {
            if (surfels_.hit(i) && surfels_.source[i] != before[i])
                marks_.add(i, Mark::Sourced | Mark::Lit | Mark::Seen);
        }
    });
    figures_.place_ms += watch.ms();
}

/// Hands the light of sources to all that show it, and their marks.
void SurfelCache::spread_light() {
    if (!cells_) return;
    const Stopwatch watch;
    for_probes(marks_.probes(), [&](std::size_t probe) {
        const std::size_t first = probe * marks_.per_probe();
        for (std::size_t i = first; i < first + marks_.per_probe(); ++i) {
            if (!surfels_.hit(i) || surfels_.own_light(i)) continue;
            const std::uint32_t source = surfels_.source[i];
            marks_.add(i, marks_.of(source) & (Mark::Lit | Mark::Seen));
            surfels_.direct[i] = surfels_.direct[source];
        }
    });
    figures_.light_ms += watch.ms();
}

/// Those of `surfels` that light is measured at, and where.
SurfelCache::Points SurfelCache::on_surfaces(std::span<const std::size_t> surfels) const {
    Points points;
    points.surfel.reserve(surfels.size());
    points.position.reserve(surfels.size());
    points.n.reserve(surfels.size());
    for (const std::size_t surfel : surfels) {
        if (!surfels_.own_light(surfel)) continue;
        points.surfel.push_back(surfel);
        points.position.push_back(surfels_.position[surfel]);
        points.n.push_back(surfels_.n[surfel]);
    }
    return points;
}

void SurfelCache::see_marked(const RayTracer& tracer) {
    if (surfels_.seen.empty()) return;
    const Stopwatch watch;
    marks_.for_marked(Mark::Seen, [&](std::span<const std::size_t> batch) {
        const auto [surfels, x, n] = on_surfaces(batch);
        std::vector<std::uint8_t> seen(x.size());
        seen_probes(tracer, grid_, x, n, seen);
        for (std::size_t i = 0; i < seen.size(); ++i) {
            const std::size_t surfel = surfels[i];
            // What is as it was need not be looked at again.
            if (surfels_.seen[surfel] == seen[i] && !renewed(surfel))
                marks_.drop(surfel, Mark::Seen);
            surfels_.seen[surfel] = seen[i];
        }
    });
    figures_.place_ms += watch.ms();
}

void SurfelCache::light_marked(const RayTracer& tracer) {
    const Stopwatch watch;
    std::atomic<std::uint64_t> shadow_rays{0};
    marks_.for_marked(Mark::Lit, [&](std::span<const std::size_t> batch) {
        const auto [surfels, x, n] = on_surfaces(batch);
        std::vector<DirectLight> light(x.size());
        direct_light(tracer, x, n, light);
        std::uint64_t rays = 0;
        for (std::size_t i = 0; i < light.size(); ++i) {
            const std::size_t surfel = surfels[i];
            rays += light[i].shadow_rays;
            if (surfels_.direct[surfel] == light[i].irradiance && !renewed(surfel))
                marks_.drop(surfel, Mark::Lit);
            surfels_.direct[surfel] = light[i].irradiance;
        }
        shadow_rays += rays;
    });
    figures_.shadow_rays = shadow_rays;
    figures_.light_ms += watch.ms();
}

}  // namespace plumbline::ddgi
