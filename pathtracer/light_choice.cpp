// SPDX-License-Identifier: Apache-2.0
#include "pathtracer/light_choice.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plumbline::pathtracer {
LightBounds light_bounds(const PointLight& light) {
    LightBounds bounds;
    bounds.box = {light.position - light.radius, light.position + light.radius};
    if (light.falloff == Falloff::InverseSquare) {
        bounds.power = strength(light.intensity);
    } else {
        bounds.constant_power = std::numbers::pi_v<float> * strength(light.white_radiance);
    }
    if (light.cone) {
        // Whole up to the inner angle: as if normals went so far.
        bounds.normals = {light.cone->direction, light.cone->inner_angle};
        // Angles come from cosines here and in spot_attenuation(), which near 0 and 180 degrees
        // have half of a float's digits left.
        constexpr float rounding = 2e-3f;
        bounds.cos_emission =
            glm::max(std::cos(light.cone->outer_angle - light.cone->inner_angle + rounding), 0.f);
    }
    return bounds;
}

LightChoice::LightChoice(const World& world)
    : tree_([&] {
          std::vector<LightBounds> bounds;
          for (const PointLight& light : world.lights) {
              const LightBounds its = light_bounds(light);
              if (its.power + its.constant_power == 0.f) continue;
              lights_.push_back(&light);
              bounds.push_back(its);
          }
          return LightTree(bounds);
      }()) {}

std::optional<LightChoice::Choice> LightChoice::choose(const glm::vec3& x, const glm::vec3& n,
                                                       float u) const {
    if (lights_.empty()) return std::nullopt;
    // The tree knows nothing of what is in between: one strong light behind a wall would take all
    // choices, and the others, with weights of 1e4 and more or a probability that rounds to 0,
    // would be missed by the picture and its variance alike. Some choices are even over all lights,
    // which bounds the weights by a defensive mixture [Hesterberg 1995].
    constexpr float even = .1f;
    const float count = static_cast<float>(lights_.size());
    if (u < even) {
        const auto light = std::min(static_cast<std::uint32_t>(u / even * count),
                                    static_cast<std::uint32_t>(lights_.size() - 1));
        return Choice{lights_[light], even / count + (1.f - even) * tree_.probability(light, x, n)};
    }
    // Below 1 even after rounding.
    const float rest = std::min((u - even) / (1.f - even), 0x1.fffffep-1f);
    const auto chosen = tree_.choose(x, n, rest);
    if (!chosen) return std::nullopt;
    return Choice{lights_[chosen->light], even / count + (1.f - even) * chosen->probability};
}

}  // namespace plumbline::pathtracer
