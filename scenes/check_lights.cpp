// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <glm/gtc/constants.hpp>

#include "scenes/check_parts.h"

namespace plumbline {
namespace {

void check_cone(const SpotCone& cone, const Checked& checked) {
    checked.expect_direction("direction", cone.direction);
    // The negations also catch NaN.
    if (!(cone.outer_angle > 0.f && cone.outer_angle <= glm::half_pi<float>())) {
        checked.fail("outer_angle", fmt::format("is {:g} degrees", glm::degrees(cone.outer_angle)),
                     "it is above 0 and at most 90");
    }
    if (!(cone.inner_angle >= 0.f && cone.inner_angle < cone.outer_angle)) {
        checked.fail("inner_angle", fmt::format("is {:g} degrees", glm::degrees(cone.inner_angle)),
                     fmt::format("it is at least 0 and below the outer angle, {:g}",
                                 glm::degrees(cone.outer_angle)));
    }
}

void check_light(const PointLight& light, const Checked& checked) {
    checked.expect_finite("position", light.position);
    checked.expect_not_negative("intensity", light.intensity);
    checked.expect_not_negative("white_radiance", light.white_radiance);
    // Below, the radiance of its surface, intensity / (pi radius^2), leaves a float's range.
    if (light.radius != 0.f && !(light.radius >= smallest_size && finite(light.radius))) {
        checked.fail("radius", fmt::format("is {:g}", light.radius),
                     fmt::format("it is 0, or {:g} or more", smallest_size));
    }
    if (!light.cone) return;
    if (light.radius > 0.f) checked.fail("radius", "does not go with a spot", "leave it out");
    check_cone(*light.cone, checked);
}

}  // namespace

void check_lights(const Scene& scene, const PlaceOf& place_of) {
    std::set<std::string> names;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const Checked checked(place_of, "lights", i);
        checked.expect_new_name(scene.lights[i].name, names);
        check_light(scene.lights[i], checked);
    }
    for (std::size_t i = 0; i < scene.directional_lights.size(); ++i) {
        const DirectionalLight& light = scene.directional_lights[i];
        const Checked checked(place_of, "directional_lights", i);
        checked.expect_new_name(light.name, names);
        checked.expect_direction("direction", light.direction);
        checked.expect_not_negative("irradiance", light.irradiance);
    }
}

}  // namespace plumbline
