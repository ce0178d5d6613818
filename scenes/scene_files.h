// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenes/scene.h"

namespace plumbline {

/// Names of the built-in scenes, sorted.
std::vector<std::string> builtin_scene_names();

/// Reads a built-in scene by name, or a .json, .gltf or .glb file. The result is checked: every
/// index is valid and every number finite and in range. Throws SceneError.
Scene load_scene(const std::string& name_or_path);

/// Writes .json or .gltf (with its .bin beside it), whole or not at all.
/// Throws SceneError, ImageError, or UsageError for another ending.
void save_scene(const Scene& scene, const std::filesystem::path& path);

}  // namespace plumbline
