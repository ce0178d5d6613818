// SPDX-License-Identifier: Apache-2.0
#include "scenes/gltf_json.h"

#include <algorithm>
#include <glm/gtc/quaternion.hpp>

namespace plumbline {

OrderedJson under_plumbline(OrderedJson extras) { return {{"plumbline", std::move(extras)}}; }

OrderedJson colour_of(const Spectrum& light, float strength) {
    const double d{strength};
    return {light.r / d, light.g / d, light.b / d};
}

OrderedJson gltf_light(const std::string& name, const char* type, const Spectrum& power) {
    const float strength = max_component(power);
    return {{"name", name},
            {"type", type},
            {"color", strength > 0.f ? colour_of(power, strength) : OrderedJson{1, 1, 1}},
            {"intensity", strength}};
}

glm::quat rotation_towards(const glm::vec3& direction) {
    const glm::vec3 unit(glm::normalize(glm::dvec3(direction)));
    return glm::normalize(glm::quat(glm::vec3(0.f, 0.f, -1.f), unit));
}

OrderedJson gltf_material(const Material& material) {
    const Spectrum& a = material.albedo;
    OrderedJson json = {{"name", material.name},
                        {"pbrMetallicRoughness",
                         {{"baseColorFactor", {shortest(a.r), shortest(a.g), shortest(a.b), 1}},
                          {"metallicFactor", 0},
                          {"roughnessFactor", 1}}},
                        {"doubleSided", material.two_sided}};
    const float strength = std::max(1.f, max_component(material.emission));
    if (material.emission != Spectrum(0.f)) {
        json["emissiveFactor"] = colour_of(material.emission, strength);
    }
    if (strength > 1.f) {
        json["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] = strength;
    }
    return json;
}

OrderedJson gltf_sampler(const Texture& texture) {
    return {{"wrapS", gltf_wraps[std::size_t(texture.wrap_u)]},
            {"wrapT", gltf_wraps[std::size_t(texture.wrap_v)]}};
}

OrderedJson shape_extras(const Box& box) {
    return {{"box",
             {{"lower", shortest(box.lower)},
              {"upper", shortest(box.upper)},
              {"face_materials", box.face_materials}}}};
}
OrderedJson shape_extras(const Quad& quad) {
    return {{"quad",
             {{"corner", shortest(quad.corner)},
              {"edge_u", shortest(quad.edge_u)},
              {"edge_v", shortest(quad.edge_v)},
              {"material", quad.material}}}};
}
OrderedJson shape_extras(const Sphere& sphere) {
    return {{"sphere",
             {{"center", shortest(sphere.center)},
              {"radius", shortest(sphere.radius)},
              {"inward", sphere.inward},
              {"material", sphere.material}}}};
}

OrderedJson gltf_camera(const Camera& camera) {
    return {{"type", "perspective"},
            {"perspective",
             {{"yfov", camera.vertical_fov},
              {"aspectRatio", double(camera.width) / camera.height},
              {"znear", 1e-3 * glm::distance(camera.eye, camera.target)}}},
            {"extras", under_plumbline({{"eye", shortest(camera.eye)},
                                        {"target", shortest(camera.target)},
                                        {"up", shortest(camera.up)},
                                        {"width", camera.width},
                                        {"height", camera.height}})}};
}

OrderedJson gltf_camera_node(const Camera& camera) {
    // A glTF camera looks along -z of its node.
    const glm::vec3 z = unit_length(camera.eye - camera.target);
    const glm::vec3 x = unit_length(glm::cross(near_unit_length(camera.up), z));
    const glm::quat rotation = glm::normalize(glm::quat_cast(glm::mat3(x, glm::cross(z, x), z)));
    return {{"name", "camera"},
            {"rotation", shortest(rotation)},
            {"translation", shortest(camera.eye)},
            {"camera", 0}};
}

OrderedJson scene_extras(const Scene& scene) {
    const OrderedJson json = settings_json(scene);
    OrderedJson extras;
    for (const char* key : {"description", "units", "environment", "frames", "report_frame",
                            "frames_per_second", "probes", "thesis"}) {
        if (json.contains(key)) extras[key] = json[key];
    }
    return extras;
}

}  // namespace plumbline
