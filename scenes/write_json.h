// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "scenes/scene.h"

namespace plumbline {

/// JSON that keeps its keys in the order in which they were set.
using OrderedJson = nlohmann::ordered_json;

/// The shortest decimal number that reads back as the same float.
OrderedJson shortest(float value);
OrderedJson shortest(const glm::vec3& value);
/// As x, y, z, w.
OrderedJson shortest(const glm::quat& value);

/// All of the scene but its materials, meshes and objects, in Plumbline's JSON format.
OrderedJson settings_json(const Scene& scene);

/// The scene in Plumbline's JSON format.
OrderedJson json_of(const Scene& scene);

/// Writes Plumbline's JSON format, whole or not at all; reading it gives the same scene.
/// Throws ImageError.
void write_json_scene(const Scene& scene, const std::filesystem::path& path);

}  // namespace plumbline
