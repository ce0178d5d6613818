// SPDX-License-Identifier: Apache-2.0
#include "ddgi/probe_distances.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <optional>

namespace plumbline::ddgi {
namespace {

constexpr float inside_share = .25f;  // [Majercik et al. 2021]

}  // namespace

/// Whether tracing the ray afresh could give another end: something moved away from it, to it, or
/// in front of it.
bool ProbeDistances::touched(const Ray& ray, const Motion& motion, std::size_t surfel) const {
    const int object = object_[surfel];
    if (object >= 0 && motion.moved[static_cast<std::size_t>(object)]) return true;
    const float length = distance_[surfel] * (1.f + distance_rounding);
    const BoxRay box_ray(ray.origin, ray.direction, length);
    return std::ranges::any_of(motion.boxes, [&](const Bounds& box) { return box_ray.meets(box); });
}

void ProbeDistances::trace(const RayTracer& tracer, const SurfelCache& cache,
                           const Motion* motion) {
    const Surfels& surfels = cache.surfels();
    rays_ = static_cast<std::size_t>(surfels.per_probe);
    distance_.resize(surfels.size());
    back_.resize(surfels.size());
    object_.resize(surfels.size());
    changed_.resize(surfels.size() / rays_);
    inside_.resize(changed_.size());
    tbb::parallel_for(std::size_t{0}, changed_.size(), [&](std::size_t probe) {
        const glm::vec3 origin = probe_position(cache.grid(), static_cast<std::uint32_t>(probe));
        bool changed = motion == nullptr;
        for (std::size_t i = probe * rays_; i < (probe + 1) * rays_; ++i) {
            const Ray ray{origin, surfels.direction[i]};
            if (motion != nullptr && !touched(ray, *motion, i)) continue;
            if (trace_ray(tracer, ray, i)) changed = true;
        }
        changed_[probe] = changed;
        if (changed) inside_[probe] = back_share(probe) >= inside_share;
    });
}

/// Whether it gave another answer than before.
bool ProbeDistances::trace_ray(const RayTracer& tracer, const Ray& ray, std::size_t surfel) {
    const std::optional<Hit> hit = tracer.intersect(ray, BackFaces::Hit);
    const float distance = hit ? hit->t : std::numeric_limits<float>::infinity();
    const std::uint8_t back = hit && hit->back;
    object_[surfel] = hit ? hit->object : -1;
    const bool other = distance_[surfel] != distance || back_[surfel] != back;
    distance_[surfel] = distance;
    back_[surfel] = back;
    return other;
}

float ProbeDistances::back_share(std::size_t probe) const {
    const auto first = back_.begin() + std::ptrdiff_t(probe * rays_);
    return static_cast<float>(std::count(first, first + std::ptrdiff_t(rays_), 1)) /
           static_cast<float>(rays_);
}

}  // namespace plumbline::ddgi
