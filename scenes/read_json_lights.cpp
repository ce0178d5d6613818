// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <glm/trigonometric.hpp>

#include "scenes/nearest_name.h"
#include "scenes/read_json.h"

namespace plumbline {
namespace {

const std::string light_types[] = {"point", "spot", "directional"};

std::string read_type(const JsonView& item) {
    const auto type = item.find("type");
    const std::string name = type ? type->text() : light_types[0];
    for (const std::string& known : light_types) {
        if (name == known) return known;
    }
    type->fail("there is no light of type " + in_quotes(name), did_you_mean(name, light_types));
}

std::string read_name(const JsonView& item, const SceneBeingRead& read) {
    const auto name = item.find("name");
    if (name) return name->text();
    const Scene& scene = read.scene;
    return fmt::format("light {}", scene.lights.size() + scene.directional_lights.size());
}

void read_power(const JsonView& item, PointLight& light) {
    const auto falloff = item.find("falloff");
    const std::string law = falloff ? falloff->text() : "inverse_square";
    if (law == "inverse_square") {
        if (const auto wrong = item.find("white_radiance")) {
            wrong->fail("does not go with falloff inverse_square",
                        "give \"intensity\", in W/sr, or set \"falloff\" to \"none\"");
        }
        light.intensity = item.at("intensity").vec3_or_number();
    } else if (law == "none") {
        light.falloff = Falloff::None;
        if (const auto wrong = item.find("intensity")) {
            wrong->fail("does not go with falloff none",
                        "give \"white_radiance\", the radiance of a white surface that faces it");
        }
        light.white_radiance = item.at("white_radiance").vec3_or_number();
    } else {
        const std::string laws[] = {"inverse_square", "none"};
        falloff->fail("there is no falloff " + in_quotes(law), did_you_mean(law, laws));
    }
}

float radians_or(const JsonView& item, const std::string& key, float otherwise) {
    const auto degrees = item.find(key);
    return degrees ? static_cast<float>(glm::radians(degrees->number())) : otherwise;
}

SpotCone read_cone(const JsonView& item) {
    SpotCone cone;
    cone.direction = item.at("direction").vec3();
    cone.inner_angle = radians_or(item, "inner_angle", cone.inner_angle);
    cone.outer_angle = radians_or(item, "outer_angle", cone.outer_angle);
    return cone;
}

PointLight read_point(const JsonView& item, bool spot) {
    if (spot) {
        item.expect_keys({"name", "type", "position", "direction", "inner_angle", "outer_angle",
                          "falloff", "intensity", "white_radiance"});
    } else {
        item.expect_keys(
            {"name", "type", "position", "falloff", "intensity", "white_radiance", "radius"});
    }
    PointLight light;
    light.position = item.at("position").vec3();
    read_power(item, light);
    if (const auto radius = item.find("radius")) light.radius = radius->real();
    if (spot) light.cone = read_cone(item);
    return light;
}

DirectionalLight read_directional(const JsonView& item) {
    item.expect_keys({"name", "type", "direction", "irradiance"});
    DirectionalLight light;
    light.direction = item.at("direction").vec3();
    light.irradiance = item.at("irradiance").vec3_or_number();
    return light;
}

}  // namespace

void read_lights(const JsonView& list, SceneBeingRead& into) {
    for (const JsonView& item : list.items()) {
        const std::string type = read_type(item);
        const std::string name = read_name(item, into);
        if (type == "directional") {
            into.directional_light_places.push_back(item.pointer());
            into.scene.directional_lights.push_back(read_directional(item));
            into.scene.directional_lights.back().name = name;
        } else {
            into.light_places.push_back(item.pointer());
            into.scene.lights.push_back(read_point(item, type == "spot"));
            into.scene.lights.back().name = name;
        }
    }
}

}  // namespace plumbline
