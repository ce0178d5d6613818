// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace plumbline {

/// What is read, in words for messages.
inline constexpr const char* image_formats =
    "an EXR, HDR, PFM, PPM, PNG, JPEG, TIFF, TGA, BMP or WebP file";

/// OpenImageIO's name of the picture's format, by its first bytes; a TGA, which has no signature,
/// by its ending. Empty if it is none of those above.
///
/// The library itself would try whatever it was built with, films and camera sensors' raw data
/// too: much code to hand a stranger's file to, for pictures that nobody compares.
std::string image_format(const std::filesystem::path& path);

}  // namespace plumbline
