// SPDX-License-Identifier: Apache-2.0
#include "scenes/read_json.h"

#include <fmt/format.h>

#include "scenes/nearest_name.h"
#include "scenes/scene_checks.h"

namespace plumbline {
namespace {

void read_materials(const JsonView& list, SceneBeingRead& into) {
    for (const JsonView& item : list.items()) {
        item.expect_keys({"name", "albedo", "texture", "emission", "two_sided"});
        Material material;
        material.name = item.at("name").text();
        const auto texture = item.find("texture");
        if (texture) material.texture = read_texture(*texture, into.folder);
        const auto albedo = texture ? item.find("albedo") : item.at("albedo");
        material.albedo = albedo ? albedo->vec3_or_number() : Spectrum(1.f);
        if (const auto emission = item.find("emission")) {
            material.emission = emission->vec3_or_number();
        }
        if (const auto two_sided = item.find("two_sided")) {
            material.two_sided = two_sided->boolean();
        }
        into.materials.emplace(material.name, static_cast<int>(into.scene.materials.size()));
        into.scene.materials.push_back(std::move(material));
        into.material_places.push_back(item.pointer());
    }
}

void read_parts(const JsonView& root, SceneBeingRead& into) {
    Scene& scene = into.scene;
    // Before the objects, since files that these bring are read at the scene's frame rate.
    read_settings(root, into.folder, scene);
    if (const auto list = root.find("materials")) read_materials(*list, into);
    if (const auto list = root.find("meshes")) read_meshes(*list, into);
    if (const auto list = root.find("objects")) read_objects(*list, into);
    if (const auto list = root.find("lights")) read_lights(*list, into);
    scene.camera = read_camera(root.at("camera"));
}

/// Places in a JSON file: pointers, which differ from the scene's own indices where objects were
/// put behind their parents and meshes came from objects.
std::string json_place(const SceneBeingRead& read, std::string_view list, std::size_t index,
                       std::string_view member) {
    std::string pointer = fmt::format("/{}", list);
    if (list == "lights") pointer = read.light_places[index];
    if (list == "directional_lights") pointer = read.directional_light_places[index];
    if (list == "materials") pointer = read.material_places[index];
    if (list == "meshes") pointer = read.mesh_places[index];
    if (list == "objects") pointer = read.object_places[index];
    return member.empty() ? pointer : fmt::format("{}/{}", pointer, member);
}

}  // namespace

int find_name(const JsonView& name, const std::map<std::string, int>& indices,
              const std::string& what) {
    const std::string wanted = name.text();
    if (const auto found = indices.find(wanted); found != indices.end()) return found->second;
    std::vector<std::string> known;
    for (const auto& [other, index] : indices) known.push_back(other);
    name.fail("there is no " + what + " " + in_quotes(wanted), did_you_mean(wanted, known));
}

Scene read_json_scene(const std::string& text, const std::string& source,
                      const std::filesystem::path& folder) {
    const JsonDocument document = parse_json(text, source);
    const JsonView root(document);
    root.expect_keys({"$schema", "name", "description", "units", "materials", "meshes", "objects",
                      "lights", "environment", "camera", "frames", "report_frame",
                      "frames_per_second", "probes", "thesis"});
    SceneBeingRead read;
    read.folder = folder;
    read.scene.name = root.at("name").text();
    read_parts(root, read);
    check_scene(read.scene, [&](std::string_view list, std::size_t index, std::string_view member) {
        return source + ": " + json_place(read, list, index, member);
    });
    return std::move(read.scene);
}

}  // namespace plumbline
