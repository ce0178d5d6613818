// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <numeric>
#include <span>

#include "pathtracer/light_tree.h"

namespace plumbline::pathtracer {
namespace {

constexpr float pi = glm::pi<float>();

/// In double: acos loses half of its argument's digits near 1.
float angle_between(const glm::vec3& a, const glm::vec3& b) {
    const glm::dvec3 x(a), y(b);
    return static_cast<float>(std::atan2(glm::length(glm::cross(x, y)), glm::dot(x, y)));
}

bool dark(const LightBounds& light) { return light.power + light.constant_power == 0.f; }

LightBounds joined(const LightBounds& a, const LightBounds& b) {
    if (dark(a)) return b;
    if (dark(b)) return a;
    LightBounds all = a;
    all.box.extend(b.box);
    all.normals = joined(a.normals, b.normals);
    all.power += b.power;
    all.two_sided = a.two_sided || b.two_sided;
    all.constant_power += b.constant_power;
    all.cos_emission = std::min(a.cos_emission, b.cos_emission);
    return all;
}

float area(const glm::vec3& size) {
    return 2.f * (size.x * size.y + size.y * size.z + size.z * size.x);
}

/// Weighted measure of the directions of light [Conty Estevez and Kulla 2018, eq. 1].
float directions(const DirectionCone& normals) {
    const float o = normals.angle;
    const float w = std::min(o + pi / 2.f, pi);
    return 2.f * pi * (1.f - std::cos(o)) + pi / 2.f *
                                                (2.f * w * std::sin(o) - std::cos(o - 2.f * w) -
                                                 2.f * o * std::sin(o) + std::cos(o));
}

glm::vec3 center(const LightBounds& light) { return (light.box.lower + light.box.upper) / 2.f; }

}  // namespace

DirectionCone joined(const DirectionCone& a, const DirectionCone& b) {
    if (b.angle > a.angle) return joined(b, a);
    const float between = angle_between(a.axis, b.axis);
    if (std::min(between + b.angle, pi) <= a.angle) return a;
    const float angle = (a.angle + between + b.angle) / 2.f;
    const glm::vec3 turn = glm::cross(a.axis, b.axis);
    if (angle >= pi || turn == glm::vec3(0.f)) return {a.axis, pi};
    const glm::quat rotation = glm::angleAxis(angle - a.angle, glm::normalize(turn));
    return {glm::normalize(rotation * a.axis), angle};
}

/// Splits the lights again and again until each is a leaf.
class LightTree::Builder {
 public:
    Builder(const std::vector<LightBounds>& lights, LightTree& tree)
        : lights_(lights), tree_(tree), order_(lights.size()) {
        std::iota(order_.begin(), order_.end(), 0u);
        tree_.leaves_.resize(lights.size());
        if (lights.empty()) return;
        Bounds all;
        for (const LightBounds& light : lights) all.extend(center(light));
        typical_d2_ = glm::dot(all.size(), all.size()) / 4.f;
        add(order_, 0);
    }

 private:
    using Range = std::span<std::uint32_t>;
    static constexpr int buckets = 12;

    std::uint32_t add(Range range, std::uint32_t parent) {
        LightBounds all;
        for (const std::uint32_t light : range) all = joined(all, lights_[light]);
        const auto index = static_cast<std::uint32_t>(tree_.nodes_.size());
        tree_.nodes_.push_back(node_of(all, parent));
        if (range.size() == 1) {
            tree_.nodes_[index].leaf = true;
            tree_.nodes_[index].light = range[0];
            tree_.leaves_[range[0]] = index;
            return index;
        }
        const std::size_t middle = split(range, all);
        add(range.first(middle), index);
        const std::uint32_t second = add(range.subspan(middle), index);
        tree_.nodes_[index].second = second;
        return index;
    }

    static Node node_of(const LightBounds& lights, std::uint32_t parent) {
        Node node{};
        node.center = center(lights);
        // Rounded up, so that the ball holds the box for sure.
        node.radius = glm::length(lights.box.size()) * .5f * (1.f + 1e-5f);
        node.axis = lights.normals.axis;
        node.cos_normals = std::cos(lights.normals.angle);
        node.sin_normals = std::sin(std::min(lights.normals.angle, pi));
        node.cos_emission = lights.cos_emission;
        node.power = lights.power;
        node.constant_power = lights.constant_power;
        node.two_sided = lights.two_sided;
        node.parent = parent;
        return node;
    }

    /// Sorts the range into two parts; how many are in the first.
    std::size_t split(Range range, const LightBounds& all) const {
        Bounds centers;
        for (const std::uint32_t light : range) centers.extend(center(lights_[light]));
        const glm::vec3 size = all.box.size();
        const bool line = area(size) == 0.f;
        float least = std::numeric_limits<float>::infinity();
        int best_axis = -1, best_bucket = 0;
        for (int axis = 0; axis < 3; ++axis) {
            if (!(centers.size()[axis] > 0.f)) continue;
            // Long sides are split first, so that nodes stay compact.
            const float stretch = max_component(size) / size[axis];
            const std::array<LightBounds, buckets> in = sorted_into(range, centers, axis);
            for (int last = 0; last + 1 < buckets; ++last) {
                const float candidate = stretch * split_cost(in, last, line);
                if (candidate < least) {
                    least = candidate;
                    best_axis = axis;
                    best_bucket = last;
                }
            }
        }
        const std::size_t half = range.size() / 2;
        if (best_axis < 0) return half;  // all in one place: any halves will do
        const auto first_of_second = std::partition(range.begin(), range.end(), [&](auto light) {
            return bucket_of(light, centers, best_axis) <= best_bucket;
        });
        const auto first = static_cast<std::size_t>(first_of_second - range.begin());
        return first == 0 || first == range.size() ? half : first;
    }

    int bucket_of(std::uint32_t light, const Bounds& centers, int axis) const {
        const float along =
            (center(lights_[light])[axis] - centers.lower[axis]) / centers.size()[axis];
        return std::clamp(static_cast<int>(along * buckets), 0, buckets - 1);
    }

    std::array<LightBounds, buckets> sorted_into(Range range, const Bounds& centers,
                                                 int axis) const {
        std::array<LightBounds, buckets> in;
        for (const std::uint32_t light : range) {
            LightBounds& bucket = in[static_cast<std::size_t>(bucket_of(light, centers, axis))];
            bucket = joined(bucket, lights_[light]);
        }
        return in;
    }

    /// Of a split after bucket `last`; infinite if a side is empty.
    float split_cost(const std::array<LightBounds, buckets>& in, int last, bool line) const {
        LightBounds first, second;
        for (int i = 0; i < buckets; ++i) {
            LightBounds& side = i <= last ? first : second;
            side = joined(side, in[static_cast<std::size_t>(i)]);
        }
        if (dark(first) || dark(second)) return std::numeric_limits<float>::infinity();
        return cost(first, line) + cost(second, line);
    }

    /// The surface area orientation heuristic [Conty Estevez and Kulla 2018, eq. 2], without the
    /// parent's terms, which are the same for all its splits; by length where all lie on a line,
    /// and no area could tell splits apart.
    float cost(const LightBounds& lights, bool line) const {
        const glm::vec3 size = lights.box.size();
        return (lights.power + lights.constant_power * typical_d2_) * directions(lights.normals) *
               (line ? max_component(size) : area(size));
    }

    const std::vector<LightBounds>& lights_;
    LightTree& tree_;
    std::vector<std::uint32_t> order_;
    float typical_d2_ = 0.f;  // from the middle of all lights to the farthest
};

LightTree::LightTree(const std::vector<LightBounds>& lights) { Builder(lights, *this); }

}  // namespace plumbline::pathtracer
