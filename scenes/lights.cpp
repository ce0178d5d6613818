// SPDX-License-Identifier: Apache-2.0
#include <glm/gtc/constants.hpp>

#include "scenes/scene.h"

namespace plumbline {

Spectrum normal_irradiance(const PointLight& light, float d2) {
    if (light.falloff == Falloff::None) return glm::pi<float>() * light.white_radiance;
    return light.intensity / d2;
}

}  // namespace plumbline
