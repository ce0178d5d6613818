// SPDX-License-Identifier: Apache-2.0
#include "scenes/nearest_name.h"
#include "scenes/read_gltf.h"

namespace plumbline {
namespace {

/// Radiant intensity or irradiance: colour times strength, in double, so that a value that was
/// split into the two comes back exactly.
Spectrum power_of(const JsonView& item) {
    const auto intensity = item.find("intensity");
    const auto colour = item.find("color");
    const std::vector<double> rgb = colour ? colour->numbers(3) : std::vector<double>(3, 1.);
    const double strength = intensity ? intensity->number() : 1.;
    return {static_cast<float>(rgb[0] * strength), static_cast<float>(rgb[1] * strength),
            static_cast<float>(rgb[2] * strength)};
}

/// The node's -z, or what the extras say of it if they agree: a direction survives as a rotation
/// only nearly.
glm::vec3 direction_of(const JsonView& item, const GltfCarrier& at) {
    const glm::vec3 seen = -glm::vec3(at.to_world[2]);
    const auto extras = plumbline_extras(item);
    const auto exact = extras ? extras->find("direction") : std::nullopt;
    if (!exact) return seen;
    constexpr float rounding = 1e-5f;
    const glm::vec3 direction = exact->vec3();
    const bool turned = !(glm::distance(unit_length(direction), unit_length(seen)) <= rounding);
    return turned ? seen : direction;
}

SpotCone cone_of(const JsonView& item, const GltfCarrier& at) {
    SpotCone cone;
    cone.direction = direction_of(item, at);
    if (const auto spot = item.find("spot")) {
        if (const auto inner = spot->find("innerConeAngle")) cone.inner_angle = inner->real();
        if (const auto outer = spot->find("outerConeAngle")) cone.outer_angle = outer->real();
    }
    return cone;
}

void read_light_extras(const JsonView& item, PointLight& light) {
    const auto extras = plumbline_extras(item);
    if (!extras) return;
    extras->expect_keys({"white_radiance", "radius", "direction"});
    if (const auto radius = extras->find("radius")) light.radius = radius->real();
    if (const auto white = extras->find("white_radiance")) {
        light.falloff = Falloff::None;
        light.white_radiance = white->vec3_or_number();
        light.intensity = Spectrum(0.f);
    }
}

}  // namespace

void read_gltf_light(const JsonView& reference, const GltfCarrier& at, GltfBeingRead& gltf) {
    const JsonView& item =
        gltf.lights[static_cast<std::size_t>(reference.index(gltf.lights.size(), "light"))];
    const std::string name = gltf.light_names(at.node, "light", at.index);
    const std::string type = item.at("type").text();
    const std::string who = "light " + in_quotes(name) + ": ";
    if (type != "point" && type != "spot" && type != "directional") {
        return gltf.note(who + type + " light; left out");
    }
    if (at.moves) gltf.note(who + "its motion; it stays where it is at frame 0");
    if (type == "directional") {
        gltf.scene.directional_lights.push_back({name, direction_of(item, at), power_of(item)});
        gltf.directional_light_places.push_back(item.pointer());
        return;
    }
    if (item.find("range")) gltf.note(who + "range; it shines at any distance");
    PointLight light;
    light.name = name;
    light.position = glm::vec3(at.to_world[3]);
    light.intensity = power_of(item);
    if (type == "spot") light.cone = cone_of(item, at);
    read_light_extras(item, light);
    gltf.scene.lights.push_back(std::move(light));
    gltf.light_places.push_back(item.pointer());
}

}  // namespace plumbline
