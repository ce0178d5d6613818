// SPDX-License-Identifier: Apache-2.0
#include "scenes/read_gltf.h"

#include <fmt/format.h>

#include <algorithm>

#include "scenes/printable.h"
#include "scenes/read_json.h"
#include "scenes/scene_checks.h"

namespace plumbline {
namespace {

// Read in full, or told in detail where they are met.
const std::string known_extensions[] = {"KHR_lights_punctual", "KHR_materials_emissive_strength",
                                        "KHR_mesh_quantization"};

/// Which scene to show: the default one, else the first.
std::optional<JsonView> scene_shown(const JsonView& root) {
    const auto scenes = root.items("scenes");
    const auto chosen = root.find("scene");
    if (chosen) return scenes[static_cast<std::size_t>(chosen->index(scenes.size(), "scene"))];
    return scenes.empty() ? std::nullopt : std::optional(scenes.front());
}

/// What the scene's own extras say, in the words of the JSON format.
void read_scene_extras(const JsonView& extras, const std::filesystem::path& folder,
                       GltfBeingRead& gltf) {
    extras.expect_keys({"description", "units", "environment", "frames", "report_frame",
                        "frames_per_second", "probes", "thesis"});
    read_settings(extras, folder, gltf.scene);
    gltf.frames_given = extras.find("frames").has_value();
}

std::string gltf_place(const GltfBeingRead& gltf, std::string_view list, std::size_t index,
                       std::string_view member) {
    std::string pointer = list == "camera" ? gltf.camera_place : "/scenes/extras/plumbline";
    if (list == "materials") pointer = fmt::format("/materials/{}", index);
    if (list == "meshes") pointer = gltf.mesh_places[index];
    if (list == "objects") pointer = gltf.object_places[index];
    if (list == "lights") pointer = gltf.light_places[index];
    if (list == "directional_lights") pointer = gltf.directional_light_places[index];
    return member.empty() ? pointer : fmt::format("{}: {}", pointer, member);
}

/// Notes what the scene as a whole says that its objects alone do not bring.
void note_scene_left_out(GltfBeingRead& gltf) {
    if (gltf.scene.environment != Spectrum(0.f)) gltf.note("its environment");
    if (gltf.scene.probes) gltf.note("its probes");
    if (gltf.scene.thesis) gltf.note("its constants of the thesis");
}

Scene read_gltf(const std::filesystem::path& path, std::optional<float> host_rate) {
    const GltfDocument document = open_gltf(path);
    GltfBeingRead gltf(document, path.parent_path(), host_rate);
    gltf.scene.name = printable(path.stem().string());
    if (const auto shown = scene_shown(gltf.root)) {
        if (const auto name = shown->find("name")) gltf.scene.name = name->text();
        if (const auto extras = plumbline_extras(*shown))
            read_scene_extras(*extras, path.parent_path(), gltf);
    }
    for (const JsonView& used : gltf.root.items("extensionsUsed")) {
        const std::string name = used.text();
        if (std::find(std::begin(known_extensions), std::end(known_extensions), name) ==
            std::end(known_extensions)) {
            gltf.note("extension " + name);
        }
    }
    read_gltf_materials(gltf);
    read_gltf_meshes(gltf);
    read_gltf_nodes(gltf);
    read_gltf_animation(gltf);
    read_gltf_carried(gltf);
    if (host_rate) note_scene_left_out(gltf);
    check_scene(gltf.scene, [&](std::string_view list, std::size_t index, std::string_view member) {
        return path.string() + ": " + gltf_place(gltf, list, index, member);
    });
    return std::move(gltf.scene);
}

}  // namespace

std::string UniqueNames::operator()(const JsonView& item, const std::string& fallback,
                                    std::size_t index) {
    const auto given = item.find("name");
    const std::string name = given ? given->text() : std::string();
    std::string unique = name.empty() ? fmt::format("{} {}", fallback, index) : name;
    // The index is the item's own, so the second try can only fail on purpose.
    if (taken_.contains(unique)) unique = fmt::format("{} ({} {})", name, fallback, index);
    while (!taken_.insert(unique).second) unique += "'";
    return unique;
}

GltfBeingRead::GltfBeingRead(const GltfDocument& document, const std::filesystem::path& folder_,
                             std::optional<float> host_rate_)
    : folder(folder_),
      host_rate(host_rate_),
      root(document.json),
      accessors(document),
      nodes(root.items("nodes")),
      cameras(root.items("cameras")),
      node_objects(nodes.size(), -1) {
    if (const auto punctual = extension(root, "KHR_lights_punctual")) {
        lights = punctual->items("lights");
    }
}

void GltfBeingRead::note(const std::string& line) {
    auto& lines = scene.not_simulated;
    if (std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(line);
}

std::optional<JsonView> plumbline_extras(const JsonView& item) {
    const auto extras = item.find("extras");
    if (!extras || !extras->is_object()) return std::nullopt;
    return extras->find("plumbline");
}

std::optional<JsonView> extension(const JsonView& item, const std::string& name) {
    const auto extensions = item.find("extensions");
    return extensions ? extensions->find(name) : std::nullopt;
}

Scene read_gltf_scene(const std::filesystem::path& path) { return read_gltf(path, std::nullopt); }

Scene read_gltf_objects(const std::filesystem::path& path, float frames_per_second) {
    return read_gltf(path, frames_per_second);
}

}  // namespace plumbline
