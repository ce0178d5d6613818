// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace plumbline {

// Whether a result can be kept is told before the work is done for it, not hours later. To know,
// these make an empty file in the nearest folder that exists, and remove it.

/// Throws ImageError if no file of this name can be written.
void check_output_file(const std::filesystem::path& file);

/// The same for pictures. Throws UsageError if the name does not end in .exr.
void check_output_picture(const std::string& file);

/// Throws UsageError if the path is a file, ImageError if no files can be written there.
void check_output_folder(const std::filesystem::path& folder);

}  // namespace plumbline
