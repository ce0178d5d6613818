// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "scenes/json_view.h"

namespace plumbline {

/// The bytes of a file. Throws SceneError if it cannot be read or is larger than 2 GiB.
std::string read_bytes(const std::filesystem::path& path);

/// The file that a scene names, relative to `folder`.
/// Throws SceneError if the name is absolute or leaves the folder by "..".
std::filesystem::path file_inside(const std::filesystem::path& folder, const std::string& name,
                                  const JsonView& place);

}  // namespace plumbline
