// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "scenes/scene.h"

namespace plumbline {
float spot_attenuation(const SpotCone& cone, const glm::vec3& to_light) {
    const float cosine = -glm::dot(to_light, cone.direction) / glm::length(to_light);
    const float inner = std::cos(cone.inner_angle);
    const float outer = std::cos(cone.outer_angle);
    // Two angles that a float cannot tell apart are a sharp edge.
    if (cosine >= inner) return 1.f;
    if (cosine <= outer) return 0.f;
    const float ramp = (cosine - outer) / (inner - outer);
    return ramp * ramp;
}

Spectrum normal_irradiance(const PointLight& light, const glm::vec3& to_light) {
    const Spectrum E = EvenLight(light).normal_irradiance(glm::dot(to_light, to_light));
    return light.cone ? E * spot_attenuation(*light.cone, to_light) : E;
}

}  // namespace plumbline
