// SPDX-License-Identifier: Apache-2.0
#include "ddgi/surfel_light.h"

#include <glm/gtc/constants.hpp>

namespace plumbline::ddgi {

void UnfedLight::take(const SurfelCache& cache, bool afresh) {
    const Surfels& surfels = cache.surfels();
    radiance_.resize(surfels.size());
    tbb::parallel_for(std::size_t{0}, surfels.size(), [&](std::size_t i) {
        if (!afresh && !cache.changed(i)) return;
        const auto& [albedo, direct] = surfels.light[i];
        radiance_[i] = surfels.emission_of(i) + albedo / glm::pi<float>() * direct;
    });
}

}  // namespace plumbline::ddgi
