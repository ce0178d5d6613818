// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "pathtracer/direct_light.h"
#include "pathtracer/sampler.h"
#include "scenes/kept_lanes.h"
#include "scenes/ray_tracer.h"

namespace plumbline::pathtracer {

/// A sampler for each path.
struct SamplerLanes {
    Lanes<std::uint32_t> key_0, key_1, place;

    Sampler operator[](std::size_t i) const {
        return Sampler(Sampler::State{key_0[i], key_1[i], place[i]});
    }
    void set(std::size_t i, const Sampler& sampler) {
        key_0[i] = sampler.state().key_0;
        key_1[i] = sampler.state().key_1;
        place[i] = sampler.state().place;
    }
};

/// Paths that are still followed, the first `rays.count` lanes: their next rays and what these
/// carry.
struct WalkLanes {
    RayLanes rays;
    Lanes3 beta;  ///< path throughput: product of f cos(theta) / pdf
    SamplerLanes sampler;
    Lanes<std::uint32_t> path;  ///< which of the paths under way
    Lanes<LastVertex> last;     ///< known where emitters are aimed at
};

/// Calls f with each of the lanes that paths carry from surface to surface, one of each of `walks`:
/// all but the ray, which the next surface decides, and `last`, which only some know.
template <typename Function, typename... Walks>
void for_each_carried(const Function& f, Walks&... walks) {
    f(walks.beta.x...);
    f(walks.beta.y...);
    f(walks.beta.z...);
    f(walks.sampler.key_0...);
    f(walks.sampler.key_1...);
    f(walks.sampler.place...);
    f(walks.path...);
}
/// The same for the ray but for its end, which no surface limits.
template <typename Function, typename... Walks>
void for_each_of_ray(const Function& f, Walks&... walks) {
    f(walks.rays.origin.x...);
    f(walks.rays.origin.y...);
    f(walks.rays.origin.z...);
    f(walks.rays.direction.x...);
    f(walks.rays.direction.y...);
    f(walks.rays.direction.z...);
}

/// Radiance that counts for paths if nothing lies between two points each.
struct LightSampleLanes {
    SegmentLanes segments;
    Lanes3 L;
    Lanes<std::uint32_t> path;

    bool full() const { return segments.count == lane_count; }
    std::size_t room() const { return lane_count - segments.count; }
    void push(const Segment& segment, const Spectrum& radiance, std::uint32_t its_path) {
        L.set(segments.count, radiance);
        path[segments.count] = its_path;
        segments.push(segment);
    }
    /// As many as `count` lanes from `first` on, all to `target`.
    void push(const Lanes3& from, const glm::vec3& target, const Lanes3& radiance,
              const Lanes<std::uint32_t>& paths, std::size_t first, std::size_t count) {
        const auto copy = [&](const auto& lanes, auto& copies) {
            std::copy_n(lanes.data() + first, count, copies.data() + segments.count);
        };
        copy(from.x, segments.a.x);
        copy(from.y, segments.a.y);
        copy(from.z, segments.a.z);
        std::fill_n(segments.b.x.data() + segments.count, count, target.x);
        std::fill_n(segments.b.y.data() + segments.count, count, target.y);
        std::fill_n(segments.b.z.data() + segments.count, count, target.z);
        copy(radiance.x, L.x);
        copy(radiance.y, L.y);
        copy(radiance.z, L.z);
        copy(paths, path);
        segments.count += count;
    }
};

}  // namespace plumbline::pathtracer
