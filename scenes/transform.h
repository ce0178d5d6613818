// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <vector>

namespace plumbline {

/// Scale, then rotate, then translate (glTF's TRS).
struct Transform {
    glm::vec3 scale{1.f};
    glm::quat rotation{1.f, 0.f, 0.f, 0.f};
    glm::vec3 translation{0.f};

    glm::mat4 matrix() const;
    bool operator==(const Transform&) const = default;
};

enum class Interpolation { Step, Linear };

/// One animated property: values at rising frames, held before the first and after the last.
template <typename T>
struct Track {
    Interpolation interpolation = Interpolation::Linear;
    std::vector<float> frames;
    std::vector<T> values;

    bool empty() const { return frames.empty(); }
    bool operator==(const Track&) const = default;
};

/// Keyframes of a transform; an empty track leaves the property at rest.
/// Rotations are interpolated spherically, along the shorter arc.
struct Animation {
    Track<glm::vec3> translation;
    Track<glm::quat> rotation;
    Track<glm::vec3> scale;

    bool empty() const { return translation.empty() && rotation.empty() && scale.empty(); }
    bool operator==(const Animation&) const = default;
};

/// The transform at `frame`, which need not be whole.
Transform transform_at(const Transform& rest, const Animation& animation, float frame);

}  // namespace plumbline
