// SPDX-License-Identifier: Apache-2.0
#include "scenes/exr_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <map>
#include <string_view>

namespace plumbline {
namespace {

/// Bytes of the types that have one size only.
const std::map<std::string, std::uint32_t, std::less<>> fixed_sizes{
    {"box2f", 16},         {"box2i", 16},    {"chromaticities", 32},
    {"compression", 1},    {"double", 8},    {"envmap", 1},
    {"deepImageState", 1}, {"float", 4},     {"int", 4},
    {"keycode", 28},       {"lineOrder", 1}, {"m33d", 72},
    {"m33f", 36},          {"m44d", 128},    {"m44f", 64},
    {"rational", 8},       {"tiledesc", 9},  {"timecode", 8},
    {"v2d", 16},           {"v2f", 8},       {"v2i", 8},
    {"v3d", 24},           {"v3f", 12},      {"v3i", 12},
};

/// A number of four bytes, the lowest first.
std::uint32_t read_number(std::istream& file) {
    std::array<unsigned char, 4> bytes{};
    file.read(reinterpret_cast<char*>(bytes.data()), bytes.size());
    return bytes[0] | std::uint32_t{bytes[1]} << 8 | std::uint32_t{bytes[2]} << 16 |
           std::uint32_t{bytes[3]} << 24;
}

std::string read_name(std::istream& file) {
    std::string name;
    std::getline(file, name, '\0');
    return name;
}

/// A list of channels: each has a name and 16 bytes, the last an empty name.
struct Channels {
    std::uint64_t count = 0;
    std::uint64_t bytes = 0;  ///< 0 if it has no end
};

Channels read_channels(std::istream& file) {
    constexpr std::streamoff a_channel = 16;
    const std::streamoff begin = file.tellg();
    Channels channels;
    for (; file && !read_name(file).empty(); ++channels.count) {
        file.seekg(a_channel, std::ios::cur);
    }
    if (file) channels.bytes = static_cast<std::uint64_t>(file.tellg() - begin);
    return channels;
}

/// Columns of a box2i: its corners are in it.
std::uint64_t read_width(std::istream& file) {
    const auto left = static_cast<std::int32_t>(read_number(file));
    read_number(file);  // the upper end
    const auto right = static_cast<std::int32_t>(read_number(file));
    // In 64 bits: windows may lie anywhere.
    return right < left ? 0 : static_cast<std::uint64_t>(std::int64_t{right} - left + 1);
}

/// Pixels of a tile: its sides begin a tiledesc.
std::uint64_t read_tile_area(std::istream& file) {
    // Longer ones count as this: their product with the channels may need more than 64 bits, and is
    // refused all the same.
    constexpr std::uint32_t longest = 1 << 20;
    const std::uint64_t width = std::min(read_number(file), longest);
    return width * std::min(read_number(file), longest);
}

std::uint64_t size_of_preview(std::istream& file) {
    const std::uint64_t width = read_number(file);
    const std::uint64_t height = read_number(file);
    // Both have 32 bits: four times their product may need more than 64, and none is so large.
    constexpr std::uint64_t largest = 1 << 24;
    return width > largest || height > largest ? 0 : 8 + 4 * width * height;
}

/// What is known of one part.
struct Part {
    std::uint64_t width = 0;
    std::uint64_t tile_area = 0;
    std::uint64_t channels = 0;
};

/// The bytes that the value fills at which the file stands, those announced if any will do; notes
/// what the part is like.
std::uint64_t read_value(std::istream& file, const std::string& name, std::string_view type,
                         std::uint32_t announced, Part& part) {
    if (type == "chlist") {
        const Channels channels = read_channels(file);
        if (name == "channels") part.channels = channels.count;
        return channels.bytes;
    }
    if (type == "preview") return size_of_preview(file);
    if (type == "box2i" && name == "dataWindow") part.width = read_width(file);
    if (type == "tiledesc") part.tile_area = read_tile_area(file);
    const auto fixed = fixed_sizes.find(type);
    return fixed == fixed_sizes.end() ? announced : fixed->second;
}

}  // namespace

ExrHeader read_exr_header(const std::filesystem::path& path) {
    const std::uintmax_t size = std::filesystem::file_size(path);
    std::ifstream file(path, std::ios::binary);
    read_number(file);  // the signature
    constexpr std::uint32_t several_parts = 0x1000;
    const bool multi_part = (read_number(file) & several_parts) != 0;
    bool after_header = true;
    Part part;
    ExrHeader header;
    while (file) {
        const std::string name = read_name(file);
        if (name.empty()) {
            // Ends a header; where there may be several, an empty one ends them all.
            if (!multi_part || after_header) break;
            after_header = true;
            part = {};
            continue;
        }
        after_header = false;
        const std::string type = read_name(file);
        const std::uint32_t announced = read_number(file);
        if (!file) break;
        const auto begin = static_cast<std::uintmax_t>(file.tellg());
        if (announced > size - begin) {
            header.fault = fmt::format("its attribute \"{}\" goes past the end of the file", name);
            break;
        }
        if (read_value(file, name, type, announced, part) != announced) {
            header.fault = fmt::format("its attribute \"{}\" of type \"{}\" cannot have {} bytes",
                                       name, type, announced);
            break;
        }
        header.values_in_row = std::max(header.values_in_row, part.width * part.channels);
        header.values_in_tile = std::max(header.values_in_tile, part.tile_area * part.channels);
        file.clear();
        file.seekg(static_cast<std::streamoff>(begin + announced));
    }
    return header;
}

}  // namespace plumbline
