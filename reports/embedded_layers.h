// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

namespace plumbline::reports {

/// RFC 4648, with padding.
std::string base64(std::span<const unsigned char> bytes);

/// Planes of numbers as the page's script unpacks them (reports/page/layers.js): half floats
/// times 2^exponent.
struct PackedPlanes {
    std::string base64;
    int exponent;
};

/// Rounds `planes` (each of `width` columns, row by row) to half floats and deflates them.
///
/// The exponent puts the largest finite magnitude near the top of a half's range: nothing
/// overflows, and relative rounding is at most 2^-11 down to 2^-28 of that magnitude. NaN and
/// infinities stay what they are.
PackedPlanes pack_planes(std::span<const std::span<const float>> planes, int width);

}  // namespace plumbline::reports
