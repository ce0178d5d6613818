// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "compare/color_maps.h"

namespace plumbline::compare {

/// A picture for a display: 8-bit sRGB, three bytes a pixel, row by row from the top left.
struct Picture {
    Picture(int w, int h, Rgb8 background);

    /// Sets a pixel; one outside the picture is not drawn.
    void set(int x, int y, Rgb8 color);

    int width, height;
    std::vector<unsigned char> rgb;
};

/// Size of text() at a scale: every character is as wide, gap included.
int text_width(const std::string& text, int scale);
int text_height(int scale);

/// Draws a number with its top left corner at (x, y), each dot of the 5 x 7 font being `scale`
/// pixels wide. It knows the digits and . + - e; another character leaves a blank.
void draw_number(Picture& picture, int x, int y, int scale, const std::string& text, Rgb8 color);

}  // namespace plumbline::compare
