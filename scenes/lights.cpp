// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "scenes/scene.h"

namespace plumbline {
namespace {

/// The share of a spot's light at an angle of this cosine off its axis.
float attenuation(const SpotCone& cone, float cosine) {
    const float inner = std::cos(cone.inner_angle);
    const float outer = std::cos(cone.outer_angle);
    // Two angles that a float cannot tell apart are a sharp edge.
    if (cosine >= inner) return 1.f;
    if (cosine <= outer) return 0.f;
    const float ramp = (cosine - outer) / (inner - outer);
    return ramp * ramp;
}

}  // namespace

Spectrum normal_irradiance(const PointLight& light, const glm::vec3& to_light) {
    const float d2 = glm::dot(to_light, to_light);
    const Spectrum E = light.falloff == Falloff::None ? glm::pi<float>() * light.white_radiance
                                                      : light.intensity / d2;
    if (!light.cone) return E;
    return E * attenuation(*light.cone, -glm::dot(to_light, light.cone->direction) / std::sqrt(d2));
}

}  // namespace plumbline
