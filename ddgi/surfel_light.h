// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tbb/parallel_for.h>

#include <vector>

#include "ddgi/surfel_cache.h"

namespace plumbline::ddgi {

/// The radiance that each surfel ray brings without any feedback from the probes: what its end
/// emits and what it scatters of the lights, or the environment's.
class UnfedLight {
 public:
    /// Takes in what the last call of `cache` changed, or with `afresh` all of it.
    void take(const SurfelCache& cache, bool afresh);

    const Spectrum& operator[](std::size_t surfel) const { return radiance_[surfel]; }

 private:
    std::vector<Spectrum> radiance_;
};

/// irradiance_of(surfel) at all surfels that light is measured at, for those that show it; empty if
/// none share.
template <typename Irradiance>
std::vector<Spectrum> at_sources(const Surfels& surfels, const Irradiance& irradiance_of) {
    std::vector<Spectrum> E(surfels.source.size());
    tbb::parallel_for(std::size_t{0}, E.size(), [&](std::size_t i) {
        if (surfels.own_light(i)) E[i] = irradiance_of(i);
    });
    return E;
}

}  // namespace plumbline::ddgi
