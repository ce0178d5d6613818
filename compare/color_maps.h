// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace plumbline::compare {

/// A display colour, sRGB-encoded.
struct Rgb8 {
    std::uint8_t r, g, b;
    bool operator==(const Rgb8&) const = default;
};

/// Colours for numbers, even in lightness and safe for colour-blind readers.
enum class ColorMap {
    Viridis,       ///< sequential, dark blue to yellow [van der Walt and Smith 2015]
    BlueWhiteRed,  ///< diverging, white in the middle: ColorBrewer RdBu [Harrower and Brewer 2003]
};

/// The colour of t in [0,1]; values outside have the colour of the nearer end.
Rgb8 map_color(ColorMap map, double t);

/// For pixels that have no value; in neither map.
inline constexpr Rgb8 no_value_color{255, 0, 255};

}  // namespace plumbline::compare
