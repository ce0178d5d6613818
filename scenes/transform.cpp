// SPDX-License-Identifier: Apache-2.0
#include "scenes/transform.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

namespace plumbline {
namespace {

glm::vec3 interpolate(const glm::vec3& a, const glm::vec3& b, float t) { return a + (b - a) * t; }
glm::quat interpolate(const glm::quat& a, const glm::quat& b, float t) {
    return glm::slerp(a, b, t);
}

template <typename T>
T value_at(const Track<T>& track, float frame) {
    const auto next = std::upper_bound(track.frames.begin(), track.frames.end(), frame);
    if (next == track.frames.begin()) return track.values.front();
    const auto i = static_cast<std::size_t>(next - track.frames.begin());
    if (i == track.frames.size()) return track.values.back();
    if (track.interpolation == Interpolation::Step) return track.values[i - 1];
    const float t = (frame - track.frames[i - 1]) / (track.frames[i] - track.frames[i - 1]);
    return interpolate(track.values[i - 1], track.values[i], t);
}

}  // namespace

glm::mat4 Transform::matrix() const {
    const glm::mat4 moved = glm::translate(glm::mat4(1.f), translation);
    return glm::scale(moved * glm::mat4_cast(rotation), scale);
}

Transform transform_at(const Transform& rest, const Animation& animation, float frame) {
    Transform transform = rest;
    if (!animation.translation.empty()) {
        transform.translation = value_at(animation.translation, frame);
    }
    if (!animation.rotation.empty()) transform.rotation = value_at(animation.rotation, frame);
    if (!animation.scale.empty()) transform.scale = value_at(animation.scale, frame);
    return transform;
}

}  // namespace plumbline
