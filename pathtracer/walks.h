// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "pathtracer/direct_light.h"
#include "pathtracer/sampler.h"
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

    /// Overwrites lane `to`, but for what the next surface decides: the ray.
    void set_carried(std::size_t to, const WalkLanes& from, std::size_t i) {
        beta.set(to, from.beta[i]);
        sampler.set(to, from.sampler[i]);
        path[to] = from.path[i];
        last[to] = from.last[i];
    }
};

/// Radiance that counts for paths if nothing lies between two points each.
struct LightSampleLanes {
    SegmentLanes segments;
    Lanes3 L;
    Lanes<std::uint32_t> path;

    bool full() const { return segments.count == lane_count; }
    void push(const Segment& segment, const Spectrum& radiance, std::uint32_t its_path) {
        L.set(segments.count, radiance);
        path[segments.count] = its_path;
        segments.push(segment);
    }
};

}  // namespace plumbline::pathtracer
