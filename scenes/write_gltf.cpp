// SPDX-License-Identifier: Apache-2.0
#include "scenes/write_gltf.h"

#include <algorithm>
#include <glm/gtc/constants.hpp>

#include "scenes/gltf_buffer.h"
#include "scenes/gltf_json.h"
#include "scenes/json_layout.h"
#include "scenes/percent_encoding.h"
#include "scenes/tessellate.h"
#include "scenes/whole_file.h"
#include "scenes/world.h"

namespace plumbline {
namespace {

/// A glTF file while it is written.
class GltfWriter {
 public:
    explicit GltfWriter(const Scene& scene) : scene_(scene) {
        const Bounds bounds = world_at(scene, 0).bounds();
        if (!bounds.empty()) typical_distance_ = glm::length(bounds.size()) / 4.f;
    }

    OrderedJson file(const std::string& buffer_name);
    const std::string& bytes() const { return buffer_.bytes(); }

 private:
    OrderedJson mesh_json(const Mesh& mesh);
    std::optional<int> mesh_index(const Object& object);
    OrderedJson object_json(const Object& object);
    void add_light(const PointLight& light);
    void add_light(const DirectionalLight& light);
    void add_light(OrderedJson light, OrderedJson node);
    template <typename T>
    void add_track(std::size_t node, const char* path, const Track<T>& track, int output);
    void add_animation();

    const Scene& scene_;
    float typical_distance_ = 1.f;  ///< from a light to a surface
    GltfBuffer buffer_;
    OrderedJson meshes_ = OrderedJson::array();
    OrderedJson nodes_ = OrderedJson::array();
    OrderedJson roots_ = OrderedJson::array();
    OrderedJson lights_ = OrderedJson::array();
    OrderedJson channels_ = OrderedJson::array();
    OrderedJson samplers_ = OrderedJson::array();
};

/// One primitive for each run of triangles of one material, so that their order stays.
OrderedJson GltfWriter::mesh_json(const Mesh& mesh) {
    OrderedJson attributes = {{"POSITION", buffer_.add_vertices(mesh.positions)}};
    if (!mesh.vertex_albedo.empty())
        attributes["COLOR_0"] = buffer_.add_vertices(mesh.vertex_albedo);
    if (!mesh.texcoords.empty()) attributes["TEXCOORD_0"] = buffer_.add_vertices(mesh.texcoords);
    OrderedJson primitives = OrderedJson::array();
    for (std::size_t first = 0; first < mesh.triangles.size();) {
        std::size_t end = first;
        while (end < mesh.triangles.size() &&
               mesh.triangle_materials[end] == mesh.triangle_materials[first]) {
            ++end;
        }
        primitives.push_back({{"attributes", attributes},
                              {"indices", buffer_.add_indices(mesh.triangles, first, end - first)},
                              {"material", mesh.triangle_materials[first]}});
        first = end;
    }
    OrderedJson json = {{"primitives", primitives}};
    if (!mesh.name.empty()) json["name"] = mesh.name;
    return json;
}

/// The scene's own meshes come first, in order; shapes get meshes behind them.
std::optional<int> GltfWriter::mesh_index(const Object& object) {
    if (const auto* instance = std::get_if<MeshInstance>(&object.shape)) return instance->mesh;
    const auto add = [&](const auto& shape) -> std::optional<int> {
        if constexpr (requires { mesh_of(shape); }) {
            OrderedJson json = mesh_json(mesh_of(shape));
            json["extras"] = under_plumbline(shape_extras(shape));
            meshes_.push_back(std::move(json));
            return static_cast<int>(meshes_.size()) - 1;
        }
        return std::nullopt;
    };
    return std::visit(add, object.shape);
}

OrderedJson GltfWriter::object_json(const Object& object) {
    OrderedJson json = {{"name", object.name}};
    const Transform none;
    const Transform& rest = object.rest;
    if (rest.scale != none.scale) json["scale"] = shortest(rest.scale);
    if (rest.rotation != none.rotation) json["rotation"] = shortest(rest.rotation);
    if (rest.translation != none.translation) json["translation"] = shortest(rest.translation);
    if (const auto mesh = mesh_index(object)) json["mesh"] = *mesh;
    return json;
}

/// A light without falloff gets, for other programs, the power that lights the scene alike at a
/// typical distance.
void GltfWriter::add_light(const PointLight& light) {
    Spectrum intensity = light.intensity;
    OrderedJson extras;
    if (light.falloff == Falloff::None) {
        intensity = glm::pi<float>() * light.white_radiance * typical_distance_ * typical_distance_;
        extras["white_radiance"] = shortest(light.white_radiance);
    }
    if (light.radius > 0.f) extras["radius"] = shortest(light.radius);
    OrderedJson json = gltf_light(light.name, light.cone ? "spot" : "point", intensity);
    OrderedJson node = {{"translation", shortest(light.position)}};
    if (light.cone) {
        json["spot"] = {{"innerConeAngle", light.cone->inner_angle},
                        {"outerConeAngle", light.cone->outer_angle}};
        extras["direction"] = shortest(light.cone->direction);
        node["rotation"] = shortest(rotation_towards(light.cone->direction));
    }
    if (!extras.empty()) json["extras"] = under_plumbline(std::move(extras));
    add_light(std::move(json), std::move(node));
}

void GltfWriter::add_light(const DirectionalLight& light) {
    OrderedJson json = gltf_light(light.name, "directional", light.irradiance);
    json["extras"] = under_plumbline({{"direction", shortest(light.direction)}});
    add_light(std::move(json), {{"rotation", shortest(rotation_towards(light.direction))}});
}

/// Adds a light and the node that carries it.
void GltfWriter::add_light(OrderedJson light, OrderedJson node) {
    node["name"] = light["name"];
    node["extensions"]["KHR_lights_punctual"]["light"] = lights_.size();
    roots_.push_back(nodes_.size());
    nodes_.push_back(std::move(node));
    lights_.push_back(std::move(light));
}

template <typename T>
void GltfWriter::add_track(std::size_t node, const char* path, const Track<T>& track, int output) {
    std::vector<float> seconds;
    OrderedJson frames = OrderedJson::array();
    for (const float frame : track.frames) {
        seconds.push_back(frame / scene_.frames_per_second);
        frames.push_back(shortest(frame));
    }
    const bool step = track.interpolation == Interpolation::Step;
    channels_.push_back(
        {{"sampler", samplers_.size()}, {"target", {{"node", node}, {"path", path}}}});
    samplers_.push_back({{"input", buffer_.add_times(seconds)},
                         {"output", output},
                         {"interpolation", step ? "STEP" : "LINEAR"},
                         {"extras", under_plumbline({{"frames", frames}})}});
}

void GltfWriter::add_animation() {
    for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
        const auto& [translation, rotation, scale] = scene_.objects[i].animation;
        if (!translation.empty()) {
            add_track(i, "translation", translation, buffer_.add_vectors(translation.values));
        }
        if (!rotation.empty()) {
            add_track(i, "rotation", rotation, buffer_.add_rotations(rotation.values));
        }
        if (!scale.empty()) add_track(i, "scale", scale, buffer_.add_vectors(scale.values));
    }
}

OrderedJson used_extensions(const Scene& scene) {
    OrderedJson used = OrderedJson::array();
    if (!scene.lights.empty() || !scene.directional_lights.empty()) {
        used.push_back("KHR_lights_punctual");
    }
    const bool bright = std::any_of(
        scene.materials.begin(), scene.materials.end(),
        [](const Material& material) { return max_component(material.emission) > 1.f; });
    if (bright) used.push_back("KHR_materials_emissive_strength");
    return used;
}

OrderedJson GltfWriter::file(const std::string& buffer_name) {
    OrderedJson materials = OrderedJson::array();
    OrderedJson textures = OrderedJson::array();
    OrderedJson images = OrderedJson::array();
    OrderedJson samplers = OrderedJson::array();
    for (const Material& material : scene_.materials) {
        materials.push_back(gltf_material(material));
        if (!material.texture) continue;
        materials.back()["pbrMetallicRoughness"]["baseColorTexture"]["index"] = textures.size();
        textures.push_back({{"source", images.size()}, {"sampler", samplers.size()}});
        images.push_back({{"uri", percent_encoded(material.texture->picture->name)}});
        samplers.push_back(gltf_sampler(*material.texture));
    }
    for (const Mesh& mesh : scene_.meshes) meshes_.push_back(mesh_json(mesh));
    for (const Object& object : scene_.objects) {
        if (object.parent == -1) roots_.push_back(nodes_.size());
        nodes_.push_back(object_json(object));
    }
    for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
        const int parent = scene_.objects[i].parent;
        if (parent != -1) nodes_[static_cast<std::size_t>(parent)]["children"].push_back(i);
    }
    for (const PointLight& light : scene_.lights) add_light(light);
    for (const DirectionalLight& light : scene_.directional_lights) add_light(light);
    roots_.push_back(nodes_.size());
    nodes_.push_back(gltf_camera_node(scene_.camera));
    add_animation();

    OrderedJson json = {
        {"asset", {{"version", "2.0"}, {"generator", "Plumbline " PLUMBLINE_VERSION}}},
        {"scene", 0},
        {"scenes", OrderedJson::array({{{"name", scene_.name},
                                        {"nodes", roots_},
                                        {"extras", under_plumbline(scene_extras(scene_))}}})},
        {"nodes", nodes_},
        {"cameras", OrderedJson::array({gltf_camera(scene_.camera)})}};
    // The format has no empty lists.
    const auto add = [&](const char* key, const OrderedJson& list) {
        if (!list.empty()) json[key] = list;
    };
    add("extensionsUsed", used_extensions(scene_));
    if (!lights_.empty()) json["extensions"]["KHR_lights_punctual"]["lights"] = lights_;
    add("materials", materials);
    add("textures", textures);
    add("images", images);
    add("samplers", samplers);
    add("meshes", meshes_);
    if (!channels_.empty()) {
        json["animations"] =
            OrderedJson::array({{{"channels", channels_}, {"samplers", samplers_}}});
    }
    add("accessors", buffer_.accessors());
    add("bufferViews", buffer_.views());
    if (!bytes().empty()) {
        json["buffers"] =
            OrderedJson::array({{{"uri", buffer_name}, {"byteLength", bytes().size()}}});
    }
    return json;
}

}  // namespace

void write_gltf_scene(const Scene& scene, const std::filesystem::path& path) {
    std::filesystem::path buffer = path;
    buffer.replace_extension(".bin");
    GltfWriter writer(scene);
    const OrderedJson json = writer.file(percent_encoded(buffer.filename().string()));
    if (!writer.bytes().empty()) write_text(buffer, writer.bytes());
    write_text(path, laid_out(json) + "\n");
}

}  // namespace plumbline
