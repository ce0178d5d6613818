// SPDX-License-Identifier: Apache-2.0
#include "ddgi/surfel_light.h"

#include <atomic>
#include <glm/gtc/constants.hpp>

namespace plumbline::ddgi {

void UnfedLight::take(const SurfelCache& cache, bool afresh) {
    const Surfels& surfels = cache.surfels();
    radiance_.resize(surfels.size());
    std::atomic<bool> any_emits = false;
    tbb::parallel_for(std::size_t{0}, surfels.size(), [&](std::size_t i) {
        if (surfels.emission[i] != Spectrum(0.f)) any_emits = true;
        if (!afresh && !cache.changed(i)) return;
        radiance_[i] = surfels.emission[i];
        if (!surfels.hit(i)) return;
        radiance_[i] += surfels.albedo[i] / glm::pi<float>() * surfels.direct[i];
    });
    any_emits_ = any_emits;
}

}  // namespace plumbline::ddgi
