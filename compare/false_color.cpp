// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/error_maps.h"

namespace plumbline::compare {

namespace {

constexpr Rgb8 paper{255, 255, 255};
constexpr Rgb8 ink{20, 20, 20};
constexpr int gap = 6;  ///< between picture, bar, ticks and border, pixels
constexpr int bar_height = 14;
constexpr int tick_height = 4;
constexpr int tick_count = 5;
constexpr int narrowest = 240;  ///< room for five numbers
constexpr int wide = 900;       ///< from here on numbers are drawn twice as large

double share_of(const ErrorMap& map, double value) {
    return (value - map.low) / (map.high - map.low);
}

void draw_map(Picture& picture, const ErrorMap& map) {
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x) {
            const float value =
                map.values[std::size_t(y) * std::size_t(map.width) + std::size_t(x)];
            picture.set(x, y,
                        std::isnan(value) ? no_value_color
                                          : map_color(map.colors, share_of(map, double(value))));
        }
}

/// The bar from `left` to `right`, its top at `top`, with ticks and numbers below.
void draw_scale(Picture& picture, const ErrorMap& map, int left, int right, int top, int scale) {
    for (int x = left; x <= right; ++x)
        for (int y = top; y < top + bar_height; ++y)
            picture.set(x, y, map_color(map.colors, double(x - left) / double(right - left)));
    for (int k = 0; k < tick_count; ++k) {
        const double share = double(k) / (tick_count - 1);
        const int x = left + int(std::lround(share * (right - left)));
        for (int y = top + bar_height; y < top + bar_height + tick_height; ++y)
            picture.set(x, y, ink);
        const std::string number = fmt::format("{:.3g}", map.low + share * (map.high - map.low));
        const int width = text_width(number, scale);
        const int start = std::clamp(x - width / 2, gap, picture.width - gap - width);
        draw_number(picture, start, top + bar_height + tick_height + 2, scale, number, ink);
    }
}

}  // namespace

Picture false_color(const ErrorMap& map) {
    const int width = std::max(map.width, narrowest);
    const int scale = width >= wide ? 2 : 1;
    const int footer = gap + bar_height + tick_height + 2 + text_height(scale) + gap;
    Picture picture(width, map.height + footer, paper);
    draw_map(picture, map);
    draw_scale(picture, map, 2 * gap, width - 2 * gap - 1, map.height + gap, scale);
    return picture;
}

}  // namespace plumbline::compare
