// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "scenes/world.h"

namespace plumbline {

bool EnvironmentImage::operator==(const EnvironmentImage& other) const {
    return rotation == other.rotation && *panorama == *other.panorama;
}

glm::vec3 EnvironmentImage::turned(const glm::vec3& direction, float angle) {
    const float c = std::cos(angle);
    const float s = std::sin(angle);
    return {c * direction.x + s * direction.z, direction.y, -s * direction.x + c * direction.z};
}

Spectrum environment_radiance(const World& world, const glm::vec3& direction) {
    if (!world.environment_image) return world.environment;
    const EnvironmentImage& image = *world.environment_image;
    const glm::vec3 in_picture = EnvironmentImage::turned(direction, -image.rotation);
    return world.environment * image.panorama->radiance[image.panorama->pixel(in_picture)];
}

}  // namespace plumbline
