// SPDX-License-Identifier: Apache-2.0
#include "pathtracer/light_tree.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace plumbline::pathtracer {
namespace {

/// cos(max(0, a - b)) of angles in [0, pi], from their sines and cosines.
float cos_of_difference(float sin_a, float cos_a, float sin_b, float cos_b) {
    return cos_a > cos_b ? 1.f : cos_a * cos_b + sin_a * sin_b;
}
float sin_of_difference(float sin_a, float cos_a, float sin_b, float cos_b) {
    return cos_a > cos_b ? 0.f : glm::max(sin_a * cos_b - cos_a * sin_b, 0.f);
}

float sine_of(float cosine) { return std::sqrt(glm::max(1.f - cosine * cosine, 0.f)); }

}  // namespace

float LightTree::importance(const Node& node, const glm::vec3& x, const glm::vec3& n) {
    const glm::vec3 way = node.center - x;
    const float d2 = glm::dot(way, way);
    const float r2 = node.radius * node.radius;
    // So large only next to a light without size; infinity would make probabilities NaN.
    constexpr float most = 1e37f;
    // Inside the ball anything may arrive from anywhere, as from the distance of its radius.
    if (d2 <= r2) {
        return glm::min(node.power / glm::max(r2, 1e-30f) + node.constant_power, most);
    }
    const glm::vec3 wi = way / std::sqrt(d2);
    // The angle under which the ball is seen: no light of the node is off `wi` by more.
    const float sin_ball = std::sqrt(r2 / d2);
    const float cos_ball = sine_of(sin_ball);

    const float cos_n = glm::clamp(glm::dot(n, wi), -1.f, 1.f);
    const float cos_receiver = cos_of_difference(sine_of(cos_n), cos_n, sin_ball, cos_ball);
    if (cos_receiver <= 0.f) return 0.f;

    float cos_axis = glm::clamp(-glm::dot(node.axis, wi), -1.f, 1.f);
    if (node.two_sided) cos_axis = std::abs(cos_axis);
    const float sin_axis = sine_of(cos_axis);
    const float cos_off = cos_of_difference(sin_axis, cos_axis, node.sin_normals, node.cos_normals);
    const float sin_off = sin_of_difference(sin_axis, cos_axis, node.sin_normals, node.cos_normals);
    const float cos_emitter = cos_of_difference(sin_off, cos_off, sin_ball, cos_ball);
    if (cos_emitter <= node.cos_emission) return 0.f;
    const float cosines = cos_receiver * cos_emitter;
    return glm::min(node.power * cosines / d2 + node.constant_power * cosines, most);
}

std::optional<float> LightTree::first_child(const Node& node, std::uint32_t index,
                                            const glm::vec3& x, const glm::vec3& n) const {
    const float first = importance(nodes_[index + 1], x, n);
    const float second = importance(nodes_[node.second], x, n);
    if (first + second <= 0.f) return std::nullopt;
    return first / (first + second);
}

std::optional<LightTree::Choice> LightTree::choose(const glm::vec3& x, const glm::vec3& n,
                                                   float u) const {
    if (nodes_.empty()) return std::nullopt;
    std::uint32_t index = 0;
    float probability = 1.f;
    while (!nodes_[index].leaf) {
        const Node& node = nodes_[index];
        const std::optional<float> first = first_child(node, index, x, n);
        if (!first) return std::nullopt;
        // What is left of `u` is again uniform, below 1 even after rounding.
        constexpr float last = 0x1.fffffep-1f;
        if (u < *first) {
            u = glm::min(u / *first, last);
            probability *= *first;
            index += 1;
        } else {
            u = glm::min((u - *first) / (1.f - *first), last);
            probability *= 1.f - *first;
            index = node.second;
        }
    }
    if (probability <= 0.f) return std::nullopt;
    return Choice{nodes_[index].light, probability};
}

float LightTree::probability(std::uint32_t light, const glm::vec3& x, const glm::vec3& n) const {
    float probability = 1.f;
    for (std::uint32_t index = leaves_[light]; index != 0;) {
        const std::uint32_t parent = nodes_[index].parent;
        const std::optional<float> first = first_child(nodes_[parent], parent, x, n);
        if (!first) return 0.f;
        probability *= index == parent + 1 ? *first : 1.f - *first;
        index = parent;
    }
    return probability;
}

int LightTree::depth() const {
    int deepest = 0;
    for (std::uint32_t index : leaves_) {
        int depth = 0;
        for (; index != 0; index = nodes_[index].parent) ++depth;
        deepest = std::max(deepest, depth);
    }
    return deepest;
}

}  // namespace plumbline::pathtracer
