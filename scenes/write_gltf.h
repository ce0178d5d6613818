// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "scenes/scene.h"

namespace plumbline {

/// Writes glTF 2.0, NAME.gltf with NAME.bin beside it, each whole or not at all.
///
/// What the format cannot say stands in `extras` under the key "plumbline", so that reading it
/// gives the same scene to the bit. Throws ImageError.
void write_gltf_scene(const Scene& scene, const std::filesystem::path& path);

}  // namespace plumbline
