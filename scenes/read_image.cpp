// SPDX-License-Identifier: Apache-2.0
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "scenes/errors.h"
#include "scenes/exr_header.h"
#include "scenes/image.h"
#include "scenes/image_format.h"
#include "scenes/printable.h"

namespace plumbline {
namespace {

/// A file may announce any size. At most so many values (4 GB) are read, and fewer from a small
/// file: the first number covers a plain picture of 7680 x 4320 pixels, which packs into next to
/// nothing.
std::uint64_t most_values(const std::filesystem::path& path) {
    constexpr std::uint64_t most = 1'000'000'000;
    constexpr std::uint64_t of_any_file = 100'000'000;
    constexpr std::uint64_t a_byte = 16;
    return std::min<std::uint64_t>(most, of_any_file + a_byte * std::filesystem::file_size(path));
}

/// Refuses an EXR file whose headers alone would take more room than any picture may.
void check_exr_header(const std::filesystem::path& path) {
    const ExrHeader header = read_exr_header(path);
    if (!header.fault.empty()) {
        throw ImageError(path.string(), "not a readable picture: " + printable(header.fault),
                         "write the file again");
    }
    const auto check = [&](std::uint64_t values, const char* what, std::uint64_t at_once) {
        const std::uint64_t most = most_values(path) / at_once;
        if (values <= most) return;
        throw ImageError(
            path.string(), fmt::format("a {} of it holds too many values", what),
            fmt::format("at most {} of a {} are read from a file of this size", most, what));
    };
    constexpr std::uint64_t rows_at_once = 256;
    constexpr std::uint64_t tiles_at_once = 32;  // two a thread, packed, unpacked and as floats
    check(header.values_in_row, "row", rows_at_once);
    check(header.values_in_tile, "tile", tiles_at_once);
}

/// Refuses a part that is no plain picture, or that does not fit beside the values that are held
/// already. A pixel counts as three values or more: a grey one may become a colour.
void check_part(const OIIO::ImageSpec& spec, std::uint64_t held, const std::string& path) {
    if (spec.width < 1 || spec.height < 1 || spec.full_width < 1 || spec.full_height < 1 ||
        spec.depth > 1 || spec.nchannels < 1) {
        throw ImageError(path, "the picture has no pixels or is a volume", "give a 2D picture");
    }
    if (spec.deep) throw ImageError(path, "its pixels have depths", "flatten the picture");
    const auto width = static_cast<std::uint64_t>(std::max(spec.full_width, spec.width));
    const auto height = static_cast<std::uint64_t>(std::max(spec.full_height, spec.height));
    const auto values = static_cast<std::uint64_t>(std::max(spec.nchannels, 3));
    const std::uint64_t most = most_values(path);
    // Sides and channels have 31 bits each: their product may need more than 64.
    if (held >= most || width > (most - held) / height / values) {
        throw ImageError(path,
                         fmt::format("{} x {} pixels of {} channels are too large", width, height,
                                     spec.nchannels),
                         fmt::format("at most {} values are read from a file of this size", most));
    }
}

/// Integers of EXR files are counts and numbers (objects, samples); those of other formats are what
/// a display shows.
bool holds_display_values(const OIIO::ImageInput& file, const OIIO::ImageSpec& spec) {
    return !spec.format.is_floating_point() && std::string(file.format_name()) != "openexr";
}

/// OpenImageIO scales integers to [0,1] when asked for floats: 32-bit numbers are scaled back.
float as_stored(float value, const OIIO::TypeDesc& type) {
    if (type != OIIO::TypeDesc::UINT32) return value;
    return static_cast<float>(
        std::round(static_cast<double>(value) * std::numeric_limits<std::uint32_t>::max()));
}

/// How a part's channel is known in the image: by its own name if that has a layer and is free,
/// else as a channel of the layer that is named as the part.
std::string name_in_image(const OIIO::ImageSpec& spec, int part, const std::string& channel,
                          const Image& image) {
    const bool layered = channel.find('.') != std::string::npos;
    if (part == 0 || (layered && !image.has_channel(channel))) return channel;
    const std::string name = spec.get_string_attribute("oiio:subimagename");
    return (name.empty() ? fmt::format("part{}", part) : name) + "." + channel;
}

/// Rows of a part, with all their channels.
struct Rows {
    int first;  ///< from the top of the part
    int count;
    std::vector<float> values;
};

/// Copies channel `c` of rows to its place in the frame; what lies outside of the frame is not
/// part of the picture, and what the part does not cover stays 0.
void place_channel(const OIIO::ImageSpec& spec, const Rows& rows, int c, bool decode,
                   const Image& image, std::span<float> target) {
    const auto channels = static_cast<std::size_t>(spec.nchannels);
    // In 64 bits: windows may lie anywhere.
    const std::int64_t left = std::int64_t{spec.x} - spec.full_x;
    const std::int64_t top = std::int64_t{spec.y} - spec.full_y + rows.first;
    const std::int64_t last_x = std::min<std::int64_t>(spec.width, image.width() - left);
    const std::int64_t last_y = std::min<std::int64_t>(rows.count, image.height() - top);
    for (std::int64_t y = std::max<std::int64_t>(0, -top); y < last_y; ++y) {
        for (std::int64_t x = std::max<std::int64_t>(0, -left); x < last_x; ++x) {
            const auto from = static_cast<std::size_t>(y * spec.width + x);
            const float value = as_stored(
                rows.values[from * channels + static_cast<std::size_t>(c)], spec.channelformat(c));
            target[static_cast<std::size_t>((y + top) * image.width() + x + left)] =
                decode ? linear_from_srgb(value) : value;
        }
    }
}

/// Reads rows one by one. For several at once the library makes room for 256, which a file of a few
/// bytes that announces millions of columns turns into gigabytes.
bool read_one_by_one(OIIO::ImageInput& file, const OIIO::ImageSpec& spec, int begin, Rows& rows) {
    const std::size_t row = rows.values.size() / static_cast<std::size_t>(rows.count);
    for (int y = 0; y < rows.count; ++y) {
        float* values = &rows.values[static_cast<std::size_t>(y) * row];
        if (!file.read_scanline(begin + y, spec.z, OIIO::TypeDesc::FLOAT, values)) return false;
    }
    return true;
}

/// Reads rows of the part that the file stands at; those of a tiled one are whole tiles. Throws
/// ImageError.
void read_rows(OIIO::ImageInput& file, int part, const OIIO::ImageSpec& spec,
               const std::string& path, Rows& rows) {
    constexpr OIIO::imagesize_t wide = 1 << 21;  // bytes: 256 rows of these take half a gigabyte
    const int begin = spec.y + rows.first;
    const int end = begin + rows.count;
    float* values = rows.values.data();
    bool read = false;
    if (spec.tile_width > 0) {
        read = file.read_tiles(part, 0, spec.x, spec.x + spec.width, begin, end, spec.z, spec.z + 1,
                               0, spec.nchannels, OIIO::TypeDesc::FLOAT, values);
    } else if (spec.scanline_bytes(true) > wide) {
        read = read_one_by_one(file, spec, begin, rows);
    } else {
        read = file.read_scanlines(part, 0, begin, end, spec.z, 0, spec.nchannels,
                                   OIIO::TypeDesc::FLOAT, values);
    }
    if (!read) {
        throw ImageError(path, "the pixels cannot be read: " + one_line(file.geterror()),
                         "write the file again");
    }
}

/// The names in the image of a part's channels; those that it has already are left out.
std::vector<std::pair<int, std::string>> new_channels(const OIIO::ImageSpec& spec, int part,
                                                      Image& image) {
    std::vector<std::pair<int, std::string>> channels;
    for (int c = 0; c < spec.nchannels; ++c) {
        const std::string name = name_in_image(spec, part, spec.channel_name(c), image);
        if (image.has_channel(name)) continue;
        image.channel(name);
        channels.emplace_back(c, name);
    }
    return channels;
}

std::size_t values_a_row(const OIIO::ImageSpec& spec) {
    return static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.nchannels);
}

/// How many rows are read together: whole tiles, and more of narrow pictures, since for each
/// reading the library makes room for 64 MB.
int rows_at_once(const OIIO::ImageSpec& spec) {
    // No format packs more rows together, so that none is unpacked twice.
    constexpr std::int64_t least_rows = 256;
    constexpr std::size_t most_values = 1 << 22;
    const auto rows = static_cast<std::int64_t>(most_values / values_a_row(spec));
    const std::int64_t tile = std::max(1, spec.tile_height);
    const std::int64_t whole_tiles = (std::max(rows, least_rows) + tile - 1) / tile * tile;
    return static_cast<int>(std::min<std::int64_t>(whole_tiles, spec.height));
}

/// Reads one part of the file into the channels that `image` lacks, some rows at a time: the
/// picture is held once, not twice.
void read_part(OIIO::ImageInput& file, int part, Image& image) {
    const OIIO::ImageSpec spec = file.spec(part);
    check_part(spec, image.pixels() * image.channel_names().size(), image.source);
    if (spec.full_width != image.width() || spec.full_height != image.height()) {
        std::string& left_out = image.metadata["plumbline:left_out"];
        left_out += fmt::format("{}part {} ({}x{})", left_out.empty() ? "" : ", ", part,
                                spec.full_width, spec.full_height);
        return;
    }
    const bool encoded = holds_display_values(file, spec);
    const auto channels = new_channels(spec, part, image);
    const int step = rows_at_once(spec);
    Rows rows{0, 0, {}};
    for (; rows.first < spec.height; rows.first += step) {
        rows.count = std::min(step, spec.height - rows.first);
        rows.values.resize(static_cast<std::size_t>(rows.count) * values_a_row(spec));
        read_rows(file, part, spec, image.source, rows);
        for (const auto& [c, name] : channels) {
            place_channel(spec, rows, c, encoded && c != spec.alpha_channel, image,
                          image.channel(name));
        }
    }
    if (encoded) image.metadata["plumbline:decoded"] = "from sRGB to linear";
}

void read_metadata(const OIIO::ImageSpec& spec, Image& image) {
    for (const OIIO::ParamValue& attribute : spec.extra_attribs) {
        if (attribute.type() == OIIO::TypeDesc::STRING) {
            image.metadata[attribute.name().string()] = attribute.get_string();
        }
    }
}

}  // namespace

Image read_image(const std::filesystem::path& path) {
    if (!std::filesystem::is_regular_file(path)) {
        throw ImageError(path.string(), "no such file", "name an image file");
    }
    const std::string format = image_format(path);
    const auto refuse = [&](const std::string& reason) {
        throw ImageError(path.string(), "not a readable picture: " + reason,
                         fmt::format("give {}", image_formats));
    };
    if (format.empty()) refuse("its first bytes are of no format that is read");
    if (format == "openexr") check_exr_header(path);
    const auto file = OIIO::ImageInput::create(format);
    if (!file) refuse(one_line(OIIO::geterror()));
    OIIO::ImageSpec as_is;
    as_is.attribute("oiio:UnassociatedAlpha", 1);  // colours as stored, never times alpha
    OIIO::ImageSpec first;
    if (!file->open(path.string(), first, as_is)) refuse(one_line(file->geterror()));
    check_part(first, 0, path.string());
    Image image(first.full_width, first.full_height);
    image.source = path.string();
    read_metadata(first, image);
    for (int part = 0; file->seek_subimage(part, 0); ++part) read_part(*file, part, image);
    return image;
}

}  // namespace plumbline
