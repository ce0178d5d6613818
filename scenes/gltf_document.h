// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenes/json_view.h"

namespace plumbline {

/// A glTF 2.0 file taken apart: its JSON and the bytes of its buffers.
struct GltfDocument {
    JsonDocument json;
    std::vector<std::string> buffers;
};

/// The bytes of a data URI, or of a file named relative to `folder`. Throws SceneError if they
/// cannot be had, or the file is not in the folder.
std::string load_uri(const JsonView& uri, const std::filesystem::path& folder);

/// Opens a .gltf with its buffers, embedded or beside it, or a .glb. Throws SceneError if anything
/// is missing, cut off, of another version, or needs an extension that is not supported.
///
/// Own code rather than tinygltf, which skips members of the wrong type in silence and knows no
/// places; of tinygltf the decoder of data URIs remains.
GltfDocument open_gltf(const std::filesystem::path& path);

}  // namespace plumbline
