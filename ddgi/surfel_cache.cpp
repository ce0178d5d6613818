// SPDX-License-Identifier: Apache-2.0
#include "ddgi/surfel_cache.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <utility>

#include "ddgi/direct_light.h"
#include "ddgi/stopwatch.h"

namespace plumbline::ddgi {
namespace {

/// Well above the relative rounding of distances, well below what moves in a frame.
constexpr float distance_rounding = 1e-5f;

/// How far rays go: to the first surface, or one cell along their longest axis.
float ray_length(Reach reach, float spacing, const glm::vec3& direction) {
    if (reach == Reach::FirstSurface) return std::numeric_limits<float>::infinity();
    return spacing / max_component(glm::abs(direction));
}

/// Whether a moved box meets the ray, or comes as near to it as `radius`: rays towards a ball stay
/// within its radius of the ray to its centre.
bool any_meets(const Motion& motion, const BoxRay& ray, float radius = 0.f) {
    return std::ranges::any_of(motion.boxes,
                               [&](const Bounds& box) { return ray.meets(box.grown(radius)); });
}

bool overlap(const Bounds& a, const Bounds& b) {
    return glm::all(glm::lessThanEqual(a.lower, b.upper)) &&
           glm::all(glm::lessThanEqual(b.lower, a.upper));
}

/// Calls body(begin, end) on ranges of whole probes' surfels, in parallel.
template <typename Body>
void for_probes(const Surfels& surfels, const Body& body) {
    const auto per_probe = static_cast<std::size_t>(surfels.per_probe);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, surfels.size() / per_probe),
                      [&](const tbb::blocked_range<std::size_t>& probes) {
                          body(probes.begin() * per_probe, probes.end() * per_probe);
                      });
}

}  // namespace

SurfelCache::SurfelCache(const ProbeGrid& grid, RayPattern pattern, Reach reach,
                         ProbeWeights weights)
    : grid_(grid), pattern_(std::move(pattern)), reach_(reach) {
    surfels_.resize(probe_count(grid), pattern_.size());
    if (weights == ProbeWeights::Visibility) surfels_.seen.resize(surfels_.size());
    tbb::parallel_for(std::uint32_t{0}, probe_count(grid), [&](std::uint32_t probe) {
        const auto directions = probe_directions(pattern_, probe_cell(grid_, probe));
        std::ranges::copy(directions,
                          surfels_.direction.begin() + std::ptrdiff_t(probe) * surfels_.per_probe);
    });
    to_place_.resize(surfels_.size());
    to_light_.resize(surfels_.size());
    if (weights == ProbeWeights::Visibility) to_see_.resize(surfels_.size());
}

void SurfelCache::rebuild(const RayTracer& tracer) {
    figures_ = {};
    std::ranges::fill(to_place_, std::uint8_t{1});
    place_marked(tracer);
    see_probes(tracer, nullptr);
    std::ranges::fill(to_light_, std::uint8_t{1});
    light_marked(tracer);
}

void SurfelCache::refresh(const RayTracer& tracer, const Motion& motion) {
    figures_ = {};
    if (motion.none()) return;
    mark_touched(tracer.world(), motion);
    place_marked(tracer);
    see_probes(tracer, &motion);
    mark_shadows(tracer.world(), motion);
    light_marked(tracer);
}

Ray SurfelCache::ray_of(std::size_t surfel) const {
    const auto per_probe = static_cast<std::size_t>(surfels_.per_probe);
    const auto probe = static_cast<std::uint32_t>(surfel / per_probe);
    const glm::vec3& direction = surfels_.direction[surfel];
    return {probe_position(grid_, probe), direction, ray_length(reach_, grid_.spacing, direction)};
}

/// Whether any ray of the probe can meet what moved: those of one cell only within a cell of it
/// [Dellson 2023, section 3.6].
bool SurfelCache::within_reach(const Motion& motion, std::size_t probe) const {
    if (reach_ == Reach::FirstSurface) return true;
    const glm::vec3 position = probe_position(grid_, static_cast<std::uint32_t>(probe));
    return std::ranges::any_of(motion.boxes, [&](const Bounds& box) {
        return box.grown(grid_.spacing).contains(position);
    });
}

/// Whether tracing the surfel's ray afresh could give another end.
bool SurfelCache::touched(const RayTracer& movers, const Motion& motion, std::size_t surfel) const {
    const int object = surfels_.object[surfel];
    const bool on_mover = object >= 0 && motion.moved[static_cast<std::size_t>(object)];
    Ray ray = ray_of(surfel);
    // What moved to right where the ray ended may be met first or second: both must be asked.
    ray.t_max = std::min(ray.t_max, surfels_.distance[surfel] * (1.f + distance_rounding));
    if (!on_mover && !any_meets(motion, {ray.origin, ray.direction, ray.t_max})) return false;
    const std::optional<Hit> hit = movers.intersect(ray, BackFaces::Cull);
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
    const Stopwatch watch;
    const World movers = moved_part(world, motion);
    const RayTracer movers_tracer(movers);
    const auto per_probe = static_cast<std::size_t>(surfels_.per_probe);
    for_probes(surfels_, [&](std::size_t begin, std::size_t end) {
        for (std::size_t surfel = begin; surfel < end; ++surfel) {
            const bool first_of_probe = surfel % per_probe == 0;
            if (first_of_probe && !within_reach(motion, surfel / per_probe)) {
                std::fill_n(to_place_.begin() + std::ptrdiff_t(surfel), per_probe, std::uint8_t{0});
                surfel += per_probe - 1;
                continue;
            }
            to_place_[surfel] = touched(movers_tracer, motion, surfel) ? 1 : 0;
        }
    });
    figures_.place_ms += watch.ms();
}

void SurfelCache::place_marked(const RayTracer& tracer) {
    const Stopwatch watch;
    std::atomic<std::uint64_t> replaced{0};
    for_probes(surfels_, [&](std::size_t begin, std::size_t end) {
        std::uint64_t placed = 0;
        for (std::size_t surfel = begin; surfel < end; ++surfel) {
            if (to_place_[surfel] == 0) continue;
            place(tracer, surfel);
            ++placed;
        }
        replaced += placed;
    });
    figures_.replaced = replaced;
    if (replaced > 0) {
        hits_ = static_cast<std::uint64_t>(std::ranges::count_if(
            surfels_.distance, [](float distance) { return std::isfinite(distance); }));
    }
    figures_.place_ms += watch.ms();
}

void SurfelCache::place(const RayTracer& tracer, std::size_t surfel) {
    const std::optional<Hit> hit = tracer.intersect(ray_of(surfel), BackFaces::Cull);
    if (!hit) {
        surfels_.distance[surfel] = std::numeric_limits<float>::infinity();
        surfels_.emission[surfel] =
            environment_radiance(tracer.world(), surfels_.direction[surfel]);
        surfels_.object[surfel] = -1;
        return;
    }
    surfels_.distance[surfel] = hit->t;
    surfels_.position[surfel] = offset_origin(*hit, hit->n());
    surfels_.n[surfel] = hit->n();
    surfels_.object[surfel] = hit->object;
    surfels_.albedo[surfel] = hit->albedo;
    surfels_.emission[surfel] =
        tracer.world().materials[static_cast<std::size_t>(hit->material)].emission;
}

/// Of each cell, named by its lowest probe, whether something moved in it.
std::vector<std::uint8_t> SurfelCache::moved_cells(const Motion& motion) const {
    std::vector<std::uint8_t> moved(probe_count(grid_));
    tbb::parallel_for(std::size_t{0}, moved.size(), [&](std::size_t probe) {
        const glm::vec3 middle =
            probe_position(grid_, static_cast<std::uint32_t>(probe)) + grid_.spacing / 2.f;
        const Bounds bounds = bounds_to_probes(grid_, middle);
        moved[probe] = std::ranges::any_of(motion.boxes,
                                           [&](const Bounds& box) { return overlap(box, bounds); });
    });
    return moved;
}

/// Asks for all, or only where something moved between a surfel and the probes around it.
void SurfelCache::see_probes(const RayTracer& tracer, const Motion* motion) {
    if (surfels_.seen.empty()) return;
    const Stopwatch watch;
    const std::vector<std::uint8_t> moved =
        motion == nullptr ? std::vector<std::uint8_t>() : moved_cells(*motion);
    const glm::vec3 last = grid_.origin + grid_.spacing * glm::vec3(grid_.counts - 1);
    const Bounds all_cells{grid_.origin, last};
    const auto moved_near = [&](std::size_t surfel) {
        const glm::vec3& x = surfels_.position[surfel];
        if (all_cells.contains(x)) return moved[cell_probe(grid_, x)] != 0;
        const Bounds bounds = bounds_to_probes(grid_, x);
        return std::ranges::any_of(motion->boxes,
                                   [&](const Bounds& box) { return overlap(box, bounds); });
    };
    for_probes(surfels_, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            to_see_[i] =
                surfels_.hit(i) && (motion == nullptr || to_place_[i] != 0 || moved_near(i));
            if (to_see_[i] == 0) continue;
            surfels_.seen[i] = seen_probes(tracer, grid_, surfels_.position[i], surfels_.n[i]);
        }
    });
    figures_.place_ms += watch.ms();
}

void SurfelCache::mark_shadows(const World& world, const Motion& motion) {
    const Stopwatch watch;
    const auto in_touched_light = [&](std::size_t surfel) {
        const glm::vec3& position = surfels_.position[surfel];
        return std::ranges::any_of(world.lights,
                                   [&](const PointLight& light) {
                                       return any_meets(motion,
                                                        {position, light.position - position, 1.f},
                                                        light.radius);
                                   }) ||
               std::ranges::any_of(world.directional_lights, [&](const DirectionalLight& light) {
                   return any_meets(motion, {position, -light.direction,
                                             std::numeric_limits<float>::infinity()});
               });
    };
    for_probes(surfels_, [&](std::size_t begin, std::size_t end) {
        for (std::size_t surfel = begin; surfel < end; ++surfel) {
            const bool relight = to_place_[surfel] != 0 || motion.lights ||
                                 (surfels_.hit(surfel) && in_touched_light(surfel));
            to_light_[surfel] = relight ? 1 : 0;
        }
    });
    figures_.light_ms += watch.ms();
}

void SurfelCache::light_marked(const RayTracer& tracer) {
    const Stopwatch watch;
    std::atomic<std::uint64_t> shadow_rays{0};
    for_probes(surfels_, [&](std::size_t begin, std::size_t end) {
        std::uint64_t rays = 0;
        for (std::size_t surfel = begin; surfel < end; ++surfel) {
            if (to_light_[surfel] == 0 || !surfels_.hit(surfel)) continue;
            const DirectLight light =
                direct_light(tracer, surfels_.position[surfel], surfels_.n[surfel]);
            surfels_.direct[surfel] = light.irradiance;
            rays += light.shadow_rays;
        }
        shadow_rays += rays;
    });
    figures_.shadow_rays = shadow_rays;
    figures_.light_ms += watch.ms();
}

}  // namespace plumbline::ddgi
