// SPDX-License-Identifier: Apache-2.0
#include "ddgi/surfel_cache.h"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
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

bool emits(const World& world) {
    return world.environment != Spectrum(0.f) ||
           std::ranges::any_of(world.materials, [](const Material& material) {
               return material.emission != Spectrum(0.f);
           });
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
    if (weights == ProbeWeights::Visibility) planes_.emplace(grid);
    if (share > 0.) {
        cells_.emplace(share * double(grid.spacing), surfels_.size());
        surfels_.source.resize(surfels_.size());
    }
}

void SurfelCache::rebuild(const RayTracer& tracer) {
    figures_ = {};
    if (emits(tracer.world())) surfels_.emission.resize(surfels_.size());
    marks_.set_all();
    take_planes(tracer.world());
    renew(tracer, false);
}

void SurfelCache::refresh(const RayTracer& tracer, const Motion& motion) {
    figures_ = {};
    marks_.clear();
    if (!motion.none()) {
        take_planes(tracer.world());
        const Stopwatch placing;
        marker_.mark_places(surfels_, motion, marks_);
        if (queue_) marker_.confirm_places(surfels_, tracer.world(), motion, marks_);
        marker_.mark_near(surfels_, motion, marks_);
        figures_.steps.mark_places += placing.ms();
        const Stopwatch lighting;
        marker_.mark_shadows(surfels_, tracer.world(), motion, hits_of_, marks_);
        leave_to_sources();
        figures_.steps.mark_shadows += lighting.ms();
    } else if (waiting() == 0) {
        return;
    }
    if (queue_) {
        const Stopwatch choosing;
        queue_->take_turn(marks_);
        figures_.steps.mark_places += choosing.ms();
    }
    renew(tracer, true);
    marks_.join();
}

void SurfelCache::take_planes(const World& world) {
    if (!planes_) return;
    const Stopwatch watch;
    planes_->take(world);
    figures_.steps.planes += watch.ms();
}

/// Surfels that light is measured at, and where they are.
struct SurfelCache::Points {
    std::vector<std::size_t> surfel;
    std::vector<glm::vec3> position;
    std::vector<glm::vec3> n;
};

/// The probes that a thread is at, room for what it finds there, and what it has done so far.
struct SurfelCache::Thread {
    std::size_t first = 0, last = 0;
    std::vector<std::size_t> marked;
    Points points;
    std::vector<std::uint8_t> seen;
    std::vector<DirectLight> lit;
    Figures figures;
};

/// Calls round(thread) for marked probes, some at a time, and adds up what was done.
template <typename Round>
void SurfelCache::in_rounds(const Round& round) {
    const Stopwatch watch;
    tbb::enumerable_thread_specific<Thread> threads;
    marks_.for_marked([&](std::size_t first, std::size_t last) {
        Thread& thread = threads.local();
        thread.first = first;
        thread.last = last;
        round(thread);
    });
    StepTimes times;
    for (const Thread& thread : threads) {
        times += thread.figures.steps;
        figures_.traced += thread.figures.traced;
        figures_.replaced += thread.figures.replaced;
        figures_.shadow_rays += thread.figures.shadow_rays;
    }
    figures_.steps += shared_out(times, watch.ms());
}

/// Does what the marks say. All steps of some probes at a time, so that what one wrote is still in
/// the cache when the next reads it; but sources are told when all surfels are placed.
void SurfelCache::renew(const RayTracer& tracer, bool unless_there) {
    in_rounds([&](Thread& thread) {
        place(tracer, unless_there, thread);
        if (cells_) return;
        see(tracer, thread);
        light(tracer, thread);
    });
    hits_ = std::reduce(hits_of_.begin(), hits_of_.end(), std::uint64_t{0});
    if (!cells_) return;
    share_light();
    in_rounds([&](Thread& thread) {
        see(tracer, thread);
        light(tracer, thread);
    });
    spread_light();
}

/// With `unless_there` those whose rays end where they did stay as they are, and lose the mark.
void SurfelCache::place(const RayTracer& tracer, bool unless_there, Thread& thread) {
    const Stopwatch watch;
    marks_.find(thread.first, thread.last, Mark::Placed, thread.marked);
    const std::span<const std::size_t> all = thread.marked;
    SurfelEnds ends(tracer);
    for (std::size_t first = 0; first < all.size(); first += plumbline::lane_count) {
        const auto part = all.subspan(first, std::min(plumbline::lane_count, all.size() - first));
        ends.trace(grid_, marker_, surfels_, part);
        for (std::size_t i = 0; i < part.size(); ++i) {
            if (unless_there && ends.is_at(surfels_, i)) {
                marks_.drop(part[i], Mark::Placed);
                continue;
            }
            put(ends, i, part[i]);
            ++thread.figures.replaced;
        }
    }
    thread.figures.traced += all.size();
    thread.figures.steps.place += watch.ms();
}

/// Puts a surfel where its ray ends, number `i` of `ends`.
void SurfelCache::put(const SurfelEnds& ends, std::size_t i, std::size_t surfel) {
    const std::size_t probe = ends.probe(i);
    marks_.add(probe, surfel, all_marks);
    hits_of_[probe] -= surfels_.hit(surfel) ? 1u : 0u;
    ends.put(surfels_, i);
    hits_of_[probe] += surfels_.hit(surfel) ? 1u : 0u;
    marker_.note_end(surfels_, probe, surfel - probe * marks_.per_probe());
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
    figures_.steps.place += watch.ms();
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
            surfels_.light[i].direct = surfels_.light[source].direct;
        }
    });
    figures_.steps.light += watch.ms();
}

/// Those that have this mark and that light is measured at.
void SurfelCache::find_points(Mark::Bit mark, Thread& thread) const {
    marks_.find(thread.first, thread.last, mark, thread.marked);
    Points& points = thread.points;
    points.surfel.clear();
    points.position.clear();
    points.n.clear();
    for (const std::size_t surfel : thread.marked) {
        if (!surfels_.own_light(surfel)) continue;
        points.surfel.push_back(surfel);
        points.position.push_back(surfels_.place[surfel].position);
        points.n.push_back(surfels_.place[surfel].n);
    }
}

void SurfelCache::see(const RayTracer& tracer, Thread& thread) {
    if (!planes_) return;
    const Stopwatch watch;
    find_points(Mark::Seen, thread);
    const auto& [surfels, x, n] = thread.points;
    thread.seen.resize(x.size());
    seen_probes(tracer, grid_, *planes_, x, n, thread.seen);
    for (std::size_t i = 0; i < surfels.size(); ++i) {
        const std::size_t surfel = surfels[i];
        // What is as it was need not be looked at again.
        if (surfels_.seen[surfel] == thread.seen[i] && !renewed(surfel))
            marks_.drop(surfel, Mark::Seen);
        surfels_.seen[surfel] = thread.seen[i];
    }
    thread.figures.steps.see += watch.ms();
}

void SurfelCache::light(const RayTracer& tracer, Thread& thread) {
    const Stopwatch watch;
    find_points(Mark::Lit, thread);
    const auto& [surfels, x, n] = thread.points;
    thread.lit.resize(x.size());
    direct_light(tracer, x, n, thread.lit);
    for (std::size_t i = 0; i < surfels.size(); ++i) {
        const std::size_t surfel = surfels[i];
        const auto& [irradiance, shadow_rays] = thread.lit[i];
        thread.figures.shadow_rays += shadow_rays;
        if (surfels_.light[surfel].direct == irradiance && !renewed(surfel))
            marks_.drop(surfel, Mark::Lit);
        surfels_.light[surfel].direct = irradiance;
    }
    thread.figures.steps.light += watch.ms();
}

}  // namespace plumbline::ddgi
