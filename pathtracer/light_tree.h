// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "scenes/geometry.h"

namespace plumbline::pathtracer {

/// Unit directions within an angle of an axis; pi is all of them.
struct DirectionCone {
    glm::vec3 axis{0.f, 0.f, 1.f};
    float angle = 3.1415927f;  ///< radians
};

/// The smallest cone around both.
DirectionCone joined(const DirectionCone& a, const DirectionCone& b);

/// What a light's spectrum counts for when one of many is chosen.
inline float strength(const Spectrum& spectrum) {
    return (spectrum.r + spectrum.g + spectrum.b) / 3.f;
}

/// Where light comes from, for choosing: a box that holds it, its power, and a cone that holds the
/// normals of its surfaces, from which they shine up to 90 degrees away, or less.
struct LightBounds {
    Bounds box;
    DirectionCone normals;
    float power = 0.f;  ///< any unit, the same for all lights
    bool two_sided = false;
    /// Of light that does not fall off with distance: as much as `power` brings from distance 1.
    float constant_power = 0.f;
    /// Light leaves a normal at angles of larger cosines than this alone.
    float cos_emission = 0.f;
};

/// Chooses one of many lights for a surface point with a probability near its share of the light
/// that arrives there unless something is in between, in time logarithmic in their number
/// [Conty Estevez and Kulla 2018].
class LightTree {
 public:
    explicit LightTree(const std::vector<LightBounds>& lights);

    struct Choice {
        std::uint32_t light;  ///< index into the lights it was made from
        float probability;    ///< above 0
    };
    /// A light for the point `x` with unit normal `n` by a number `u` of [0,1); none if no light
    /// can reach that side of the surface.
    std::optional<Choice> choose(const glm::vec3& x, const glm::vec3& n, float u) const;

    /// The probability with which choose() gives `light`.
    float probability(std::uint32_t light, const glm::vec3& x, const glm::vec3& n) const;

    /// Decisions that choose() takes at most.
    int depth() const;

 private:
    struct Node {
        glm::vec3 center;  ///< of a ball around the box
        float radius;
        glm::vec3 axis;
        float cos_normals;  ///< of the cone of normals
        float sin_normals;
        float cos_emission;
        float power;
        float constant_power;
        std::uint32_t second;  ///< of an inner node: its second child; the first is next to it
        std::uint32_t parent;
        std::uint32_t light;  ///< of a leaf
        bool leaf;
        bool two_sided;
    };

    /// An estimate of the light from the node; zero only if none can arrive.
    static float importance(const Node& node, const glm::vec3& x, const glm::vec3& n);
    /// The probability of the first child of an inner node; none if no child's light arrives.
    std::optional<float> first_child(const Node& node, std::uint32_t index, const glm::vec3& x,
                                     const glm::vec3& n) const;

    class Builder;

    std::vector<Node> nodes_;            ///< depth first, the root at 0
    std::vector<std::uint32_t> leaves_;  ///< by light
};

}  // namespace plumbline::pathtracer
