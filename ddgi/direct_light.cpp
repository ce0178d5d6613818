// SPDX-License-Identifier: Apache-2.0
#include "ddgi/direct_light.h"

namespace plumbline::ddgi {

DirectLight direct_light(const RayTracer& tracer, const glm::vec3& position, const glm::vec3& n,
                         int rays) {
    DirectLight result;
    for (const PointLight& light : tracer.world().lights) {
        const glm::vec3 way = light.position - position;
        const float height = glm::dot(n, way);
        if (height <= 0.f) continue;
        const float d2 = glm::dot(way, way);
        int arriving = 0;
        for (int ray = 0; ray < rays; ++ray) {
            if (!tracer.occluded(position, light.position)) ++arriving;
        }
        result.shadow_rays += static_cast<std::uint32_t>(rays);
        const float visibility = static_cast<float>(arriving) / static_cast<float>(rays);
        result.irradiance += visibility * height / std::sqrt(d2) * normal_irradiance(light, d2);
    }
    return result;
}

}  // namespace plumbline::ddgi
