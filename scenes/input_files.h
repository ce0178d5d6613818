// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace plumbline {

/// The bytes of a file. Throws SceneError if it cannot be read or is larger than 2 GiB.
std::string read_bytes(const std::filesystem::path& path);

}  // namespace plumbline
