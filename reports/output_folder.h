// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace plumbline::reports {

/// Files of a study by name, each with its bytes.
using FolderFiles = std::vector<std::pair<std::string, std::string>>;

/// Writes every file whole, under temporary names first: if one cannot be written, none replaces
/// what was there. Makes the folder. Throws ImageError.
void write_folder(const std::filesystem::path& folder, const FolderFiles& files);

}  // namespace plumbline::reports
