// SPDX-License-Identifier: Apache-2.0
#include "scenes/write_json.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <limits>

#include "scenes/json_layout.h"
#include "scenes/whole_file.h"

namespace plumbline {
namespace {

const char* const face_names[] = {"+x", "-x", "+y", "-y", "+z", "-z"};

/// Degrees with as few digits as lead back to the same radians.
OrderedJson shortest_degrees(float radians) {
    const double degrees = glm::degrees(double{radians});
    for (int digits = 1; digits < std::numeric_limits<double>::max_digits10; ++digits) {
        const double rounded = std::stod(fmt::format("{:.{}g}", degrees, digits));
        if (static_cast<float>(glm::radians(rounded)) == radians) return rounded;
    }
    return degrees;
}

template <typename T>
OrderedJson track_json(const Track<T>& track) {
    OrderedJson json;
    if (track.interpolation == Interpolation::Step) json["interpolation"] = "step";
    json["frames"] = OrderedJson::array();
    json["values"] = OrderedJson::array();
    for (const float frame : track.frames) json["frames"].push_back(shortest(frame));
    for (const T& value : track.values) json["values"].push_back(shortest(value));
    return json;
}

OrderedJson animation_json(const Animation& animation) {
    OrderedJson json;
    if (!animation.translation.empty()) json["translation"] = track_json(animation.translation);
    if (!animation.rotation.empty()) json["rotation"] = track_json(animation.rotation);
    if (!animation.scale.empty()) json["scale"] = track_json(animation.scale);
    return json;
}

/// Both axes of a scene file's texture wrap alike; the rarer other case takes that of u.
OrderedJson texture_json(const Texture& texture) {
    constexpr std::array wraps{"repeat", "mirror", "clamp"};
    return {{"image", texture.picture->name}, {"wrap", wraps[std::size_t(texture.wrap_u)]}};
}

OrderedJson material_json(const Material& material) {
    OrderedJson json = {{"name", material.name}, {"albedo", shortest(material.albedo)}};
    if (material.texture) json["texture"] = texture_json(*material.texture);
    if (material.emission != Spectrum(0.f)) json["emission"] = shortest(material.emission);
    if (material.two_sided) json["two_sided"] = true;
    return json;
}

OrderedJson mesh_json(const Mesh& mesh, const Scene& scene) {
    OrderedJson json = {{"name", mesh.name}, {"positions", OrderedJson::array()}};
    for (const glm::vec3& position : mesh.positions)
        json["positions"].push_back(shortest(position));
    for (const Spectrum& albedo : mesh.vertex_albedo) {
        json["vertex_albedo"].push_back(shortest(albedo));
    }
    for (const glm::vec2& uv : mesh.texcoords) {
        json["texcoords"].push_back({shortest(uv.x), shortest(uv.y)});
    }
    json["triangles"] = OrderedJson::array();
    json["triangle_materials"] = OrderedJson::array();
    for (const glm::uvec3& t : mesh.triangles) json["triangles"].push_back({t.x, t.y, t.z});
    for (const int material : mesh.triangle_materials) {
        json["triangle_materials"].push_back(scene.materials[std::size_t(material)].name);
    }
    return json;
}

/// Adds an object's shape to its JSON, whatever it is.
struct WriteShape {
    const Scene& scene;
    OrderedJson& object;

    const std::string& material(int index) const {
        return scene.materials[std::size_t(index)].name;
    }
    void operator()(std::monostate) const {}
    void operator()(const Box& box) const {
        OrderedJson& json = object["box"];
        json = {{"lower", shortest(box.lower)}, {"upper", shortest(box.upper)}};
        const int common = box.face_materials[0];
        json["material"] = material(common);
        for (std::size_t i = 1; i < box.face_materials.size(); ++i) {
            if (box.face_materials[i] == common) continue;
            json["faces"][face_names[i]] = material(box.face_materials[i]);
        }
    }
    void operator()(const Quad& quad) const {
        object["quad"] = {{"corner", shortest(quad.corner)},
                          {"edge_u", shortest(quad.edge_u)},
                          {"edge_v", shortest(quad.edge_v)},
                          {"material", material(quad.material)}};
    }
    void operator()(const Sphere& sphere) const {
        object["sphere"] = {{"center", shortest(sphere.center)},
                            {"radius", shortest(sphere.radius)},
                            {"inward", sphere.inward},
                            {"material", material(sphere.material)}};
    }
    void operator()(const MeshInstance& instance) const {
        object["mesh"] = scene.meshes[std::size_t(instance.mesh)].name;
    }
};

OrderedJson object_json(const Object& object, const Scene& scene) {
    OrderedJson json = {{"name", object.name}};
    if (object.parent != -1) json["parent"] = scene.objects[std::size_t(object.parent)].name;
    std::visit(WriteShape{scene, json}, object.shape);
    const Transform none;
    if (object.rest.scale != none.scale) json["scale"] = shortest(object.rest.scale);
    if (object.rest.rotation != none.rotation) json["rotation"] = shortest(object.rest.rotation);
    if (object.rest.translation != none.translation) {
        json["translation"] = shortest(object.rest.translation);
    }
    if (!object.animation.empty()) json["animation"] = animation_json(object.animation);
    return json;
}

OrderedJson light_json(const PointLight& light) {
    OrderedJson json = {{"name", light.name}};
    if (light.cone) json["type"] = "spot";
    json["position"] = shortest(light.position);
    const bool physical = light.falloff == Falloff::InverseSquare;
    json["falloff"] = physical ? "inverse_square" : "none";
    if (physical) {
        json["intensity"] = shortest(light.intensity);
    } else {
        json["white_radiance"] = shortest(light.white_radiance);
    }
    if (light.radius > 0.f) json["radius"] = shortest(light.radius);
    if (light.cone) {
        json["direction"] = shortest(light.cone->direction);
        json["inner_angle"] = shortest_degrees(light.cone->inner_angle);
        json["outer_angle"] = shortest_degrees(light.cone->outer_angle);
    }
    return json;
}

OrderedJson light_json(const DirectionalLight& light) {
    return {{"name", light.name},
            {"type", "directional"},
            {"direction", shortest(light.direction)},
            {"irradiance", shortest(light.irradiance)}};
}

OrderedJson environment_json(const Scene& scene) {
    if (!scene.environment_image) return shortest(scene.environment);
    const EnvironmentImage& image = *scene.environment_image;
    return {{"image", image.panorama->file.filename().string()},
            {"radiance", shortest(scene.environment)},
            {"rotation", shortest_degrees(image.rotation)}};
}

OrderedJson camera_json(const Camera& camera) {
    return {{"eye", shortest(camera.eye)}, {"target", shortest(camera.target)},
            {"up", shortest(camera.up)},   {"vertical_fov", shortest_degrees(camera.vertical_fov)},
            {"width", camera.width},       {"height", camera.height}};
}

OrderedJson probes_json(const ProbeGrid& probes) {
    return {{"origin", shortest(probes.origin)},
            {"spacing", shortest(probes.spacing)},
            {"counts", {probes.counts.x, probes.counts.y, probes.counts.z}}};
}

OrderedJson thesis_json(const ThesisConstants& thesis) {
    return {{"falloffRegulator", shortest(thesis.falloffRegulator)},
            {"bounceAttenuation", shortest(thesis.bounceAttenuation)},
            {"probeBrightness", shortest(thesis.probeBrightness)},
            {"multiBounceIntensity", shortest(thesis.multiBounceIntensity)},
            {"ambient", shortest(thesis.ambient)},
            {"imageBrightness", shortest(thesis.imageBrightness)}};
}

}  // namespace

OrderedJson shortest(float value) {
    // Whole numbers without a decimal point, up to where a float counts in ones.
    constexpr float largest_count = 1 << 24;
    const bool minus_zero = value == 0.f && std::signbit(value);
    if (value == std::trunc(value) && std::abs(value) <= largest_count && !minus_zero) {
        return static_cast<int>(value);
    }
    char text[32];
    const auto written = std::to_chars(text, text + sizeof text, value);
    double decimal = 0;
    std::from_chars(text, written.ptr, decimal);
    // Rounding twice, to double and to float, may in rare cases end at a neighbour.
    return static_cast<float>(decimal) == value ? decimal : double{value};
}

OrderedJson shortest(const glm::vec3& value) {
    return {shortest(value.x), shortest(value.y), shortest(value.z)};
}

OrderedJson shortest(const glm::quat& value) {
    return {shortest(value.x), shortest(value.y), shortest(value.z), shortest(value.w)};
}

OrderedJson settings_json(const Scene& scene) {
    OrderedJson json = {{"name", scene.name}, {"description", scene.description}};
    if (!scene.length_unit.empty()) json["units"] = scene.length_unit;
    json["lights"] = OrderedJson::array();
    for (const PointLight& light : scene.lights) json["lights"].push_back(light_json(light));
    for (const DirectionalLight& light : scene.directional_lights) {
        json["lights"].push_back(light_json(light));
    }
    json["environment"] = environment_json(scene);
    json["camera"] = camera_json(scene.camera);
    json["frames"] = scene.frames;
    json["report_frame"] = scene.report_frame;
    json["frames_per_second"] = shortest(scene.frames_per_second);
    if (scene.probes) json["probes"] = probes_json(*scene.probes);
    if (scene.thesis) json["thesis"] = thesis_json(*scene.thesis);
    return json;
}

OrderedJson json_of(const Scene& scene) {
    const OrderedJson settings = settings_json(scene);
    OrderedJson json;
    for (const char* key : {"name", "description", "units"}) {
        if (settings.contains(key)) json[key] = settings[key];
    }
    json["materials"] = OrderedJson::array();
    for (const Material& material : scene.materials) {
        json["materials"].push_back(material_json(material));
    }
    for (const Mesh& mesh : scene.meshes) json["meshes"].push_back(mesh_json(mesh, scene));
    json["objects"] = OrderedJson::array();
    for (const Object& object : scene.objects) {
        json["objects"].push_back(object_json(object, scene));
    }
    json.update(settings);
    return json;
}

void write_json_scene(const Scene& scene, const std::filesystem::path& path) {
    write_text(path, laid_out(json_of(scene)) + "\n");
}

}  // namespace plumbline
