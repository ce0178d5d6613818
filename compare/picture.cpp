// SPDX-License-Identifier: Apache-2.0
#include "compare/picture.h"

#include <array>
#include <map>

namespace plumbline::compare {

namespace {

constexpr int glyph_width = 5;
constexpr int glyph_height = 7;

/// Rows from the top; the highest of five bits is the left dot.
using Glyph = std::array<unsigned, glyph_height>;

const std::map<char, Glyph> glyphs{
    {'0', {0b01110, 0b10001, 0b10011, 0b10101, 0b11001, 0b10001, 0b01110}},
    {'1', {0b00100, 0b01100, 0b00100, 0b00100, 0b00100, 0b00100, 0b01110}},
    {'2', {0b01110, 0b10001, 0b00001, 0b00110, 0b01000, 0b10000, 0b11111}},
    {'3', {0b01110, 0b10001, 0b00001, 0b00110, 0b00001, 0b10001, 0b01110}},
    {'4', {0b00010, 0b00110, 0b01010, 0b10010, 0b11111, 0b00010, 0b00010}},
    {'5', {0b11111, 0b10000, 0b11110, 0b00001, 0b00001, 0b10001, 0b01110}},
    {'6', {0b00110, 0b01000, 0b10000, 0b11110, 0b10001, 0b10001, 0b01110}},
    {'7', {0b11111, 0b00001, 0b00010, 0b00100, 0b01000, 0b01000, 0b01000}},
    {'8', {0b01110, 0b10001, 0b10001, 0b01110, 0b10001, 0b10001, 0b01110}},
    {'9', {0b01110, 0b10001, 0b10001, 0b01111, 0b00001, 0b00010, 0b01100}},
    {'.', {0b00000, 0b00000, 0b00000, 0b00000, 0b00000, 0b01100, 0b01100}},
    {'-', {0b00000, 0b00000, 0b00000, 0b11111, 0b00000, 0b00000, 0b00000}},
    {'+', {0b00000, 0b00100, 0b00100, 0b11111, 0b00100, 0b00100, 0b00000}},
    {'e', {0b00000, 0b00000, 0b01110, 0b10001, 0b11111, 0b10000, 0b01110}},
};

}  // namespace

Picture::Picture(int w, int h, Rgb8 background) : width(w), height(h) {
    rgb.reserve(std::size_t(w) * std::size_t(h) * 3);
    for (std::size_t i = 0; i < std::size_t(w) * std::size_t(h); ++i)
        rgb.insert(rgb.end(), {background.r, background.g, background.b});
}

void Picture::set(int x, int y, Rgb8 color) {
    if (x < 0 || y < 0 || x >= width || y >= height) return;
    const std::size_t i = (std::size_t(y) * std::size_t(width) + std::size_t(x)) * 3;
    rgb[i] = color.r;
    rgb[i + 1] = color.g;
    rgb[i + 2] = color.b;
}

int text_width(const std::string& text, int scale) {
    return text.empty() ? 0 : (int(text.size()) * (glyph_width + 1) - 1) * scale;
}

int text_height(int scale) { return glyph_height * scale; }

void draw_number(Picture& picture, int x, int y, int scale, const std::string& text, Rgb8 color) {
    for (char character : text) {
        const auto found = glyphs.find(character);
        for (int j = 0; found != glyphs.end() && j < glyph_height * scale; ++j)
            for (int i = 0; i < glyph_width * scale; ++i) {
                const unsigned row = found->second[std::size_t(j / scale)];
                if (row >> (glyph_width - 1 - i / scale) & 1u) picture.set(x + i, y + j, color);
            }
        x += (glyph_width + 1) * scale;
    }
}

}  // namespace plumbline::compare
