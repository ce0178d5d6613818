// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "reports/scene_report.h"

namespace plumbline::reports {

/// 8-bit RGB, row by row from the top left, as the bytes of a PNG file.
std::vector<unsigned char> png_bytes(int width, int height, const std::vector<unsigned char>& rgb);

/// The same as a data URI.
std::string png_uri(int width, int height, const std::vector<unsigned char>& rgb);

/// A layer as sRGB bytes after scaling by 2^stops. Brighter than white is white, and what is not
/// finite is black: a display has no more.
std::vector<unsigned char> display_bytes(const Image& image, const std::string& layer,
                                         double stops);

/// The exposure, in stops, at which all pictures of a scene are shown: the nearest half stop that
/// brings the truth's 99th percentile to white.
double exposure_of(const SceneReport& report);

}  // namespace plumbline::reports
