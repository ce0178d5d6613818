// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "ddgi/surfel_cache.h"

namespace plumbline::ddgi {

/// How far the rays of all probes see, where surfel rays may not stop: backs of one-sided surfaces,
/// through which surfel rays pass, hide what is behind them from the points of a scene.
class ProbeDistances {
 public:
    /// Takes the rays of `cache`: all of them afresh, or those alone that `motion` touches, if it
    /// leads here from the world of the last call. The answers are the same.
    void trace(const RayTracer& tracer, const SurfelCache& cache, const Motion* motion);

    /// To the nearest surface; infinite if there is none.
    float distance(std::size_t surfel) const { return distance_[surfel]; }
    /// Whether that surface shows its back.
    bool back(std::size_t surfel) const { return back_[surfel] != 0; }
    /// Whether the last call changed anything of the probe.
    bool changed(std::size_t probe) const { return changed_[probe] != 0; }
    /// The share of the probe's rays that meet a back first.
    float back_share(std::size_t probe) const;
    /// Whether the probe stands in something: a quarter or more of its rays meet backs
    /// [Majercik et al. 2021].
    bool inside(std::size_t probe) const { return inside_[probe] != 0; }

 private:
    bool trace_ray(const RayTracer& tracer, const Ray& ray, std::size_t surfel);
    bool touched(const Ray& ray, const Motion& motion, std::size_t surfel) const;

    std::size_t rays_ = 0;
    std::vector<float> distance_;
    std::vector<std::uint8_t> back_;
    std::vector<int> object_;  ///< that was met; -1 for none
    std::vector<std::uint8_t> changed_;
    std::vector<std::uint8_t> inside_;
};

}  // namespace plumbline::ddgi
