// SPDX-License-Identifier: Apache-2.0
#include "scenes/camera_rays.h"

#include <cmath>

namespace plumbline {

CameraRays::CameraRays(const Camera& camera) : eye_(camera.eye) {
    const glm::vec3 forward = unit_length(camera.target - camera.eye);
    const glm::vec3 right = unit_length(glm::cross(forward, near_unit_length(camera.up)));
    const glm::vec3 up = glm::cross(right, forward);
    const auto width = static_cast<float>(camera.width);
    const auto height = static_cast<float>(camera.height);
    const float half_height = std::tan(camera.vertical_fov / 2.f);
    const float pixel = 2.f * half_height / height;
    right_ = right * pixel;
    down_ = -up * pixel;
    corner_ = forward - right_ * (width / 2.f) - down_ * (height / 2.f);
}

}  // namespace plumbline
