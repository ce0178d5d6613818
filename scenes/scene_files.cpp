// SPDX-License-Identifier: Apache-2.0
#include "scenes/scene_files.h"

#include <algorithm>
#include <span>

#include "scenes/embedded_files.h"
#include "scenes/errors.h"
#include "scenes/input_files.h"
#include "scenes/nearest_name.h"
#include "scenes/read_gltf.h"
#include "scenes/read_json.h"
#include "scenes/whole_file.h"
#include "scenes/write_gltf.h"
#include "scenes/write_json.h"

namespace plumbline {

std::span<const EmbeddedFile> embedded_scenes_files();

namespace {

std::string scene_name(const EmbeddedFile& file) {
    return std::filesystem::path(file.name).stem().string();
}

/// Puts a picture that a scene file names beside it; never over another file.
void put_beside(const std::filesystem::path& folder, const std::string& name,
                const std::string& bytes) {
    const std::filesystem::path file = folder / name;
    if (std::filesystem::exists(file)) {
        if (read_bytes(file) == bytes) return;
        throw UsageError(file.string(), "another file of this name stands where a picture belongs",
                         "write the scene into a folder of its own");
    }
    write_text(file, bytes);
}

void put_pictures_beside(const Scene& scene, const std::filesystem::path& folder) {
    for (const Material& material : scene.materials) {
        if (!material.texture) continue;
        const Picture& picture = *material.texture->picture;
        put_beside(folder, picture.name, picture.encoded);
    }
    if (!scene.environment_image) return;
    const std::filesystem::path& sky = scene.environment_image->panorama->file;
    put_beside(folder, sky.filename().string(), read_bytes(sky));
}

}  // namespace

std::vector<std::string> builtin_scene_names() {
    std::vector<std::string> names;
    for (const EmbeddedFile& file : embedded_scenes_files()) names.push_back(scene_name(file));
    std::sort(names.begin(), names.end());
    return names;
}

Scene load_scene(const std::string& name_or_path) {
    for (const EmbeddedFile& file : embedded_scenes_files()) {
        if (scene_name(file) != name_or_path) continue;
        return read_json_scene(std::string(file.text), "built-in scene " + name_or_path, {});
    }
    const std::filesystem::path path(name_or_path);
    const std::string ending = path.extension().string();
    if (ending == ".json") {
        return read_json_scene(read_bytes(path), path.string(), path.parent_path());
    }
    if (ending == ".gltf" || ending == ".glb") return read_gltf_scene(path);
    throw SceneError(
        in_quotes(name_or_path), "is neither a built-in scene nor a file that can be read",
        did_you_mean(name_or_path, builtin_scene_names()) + " files end in .json, .gltf or .glb");
}

void save_scene(const Scene& scene, const std::filesystem::path& path) {
    const std::string ending = path.extension().string();
    if (ending == ".json" || ending == ".gltf") put_pictures_beside(scene, path.parent_path());
    if (ending == ".json") return write_json_scene(scene, path);
    if (ending == ".gltf") return write_gltf_scene(scene, path);
    throw UsageError(path.string(), "scenes are not written as " + in_quotes(ending),
                     "end the name in .json or .gltf");
}

}  // namespace plumbline
