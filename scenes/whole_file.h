// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace plumbline {

/// Lets `write` write to a temporary name beside `path`, then renames it: readers see the old file
/// or the new one, never half of one. Makes missing folders. If `write` throws, nothing is left.
/// Throws ImageError if the folder cannot be made or the file cannot be renamed.
void write_whole(const std::filesystem::path& path,
                 const std::function<void(const std::filesystem::path& temporary)>& write);

/// Writes text whole or not at all. Throws ImageError.
void write_text(const std::filesystem::path& path, std::string_view text);

}  // namespace plumbline
