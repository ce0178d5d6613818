// SPDX-License-Identifier: Apache-2.0
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "scenes/errors.h"
#include "scenes/image.h"
#include "scenes/whole_file.h"

namespace plumbline {
namespace {

/// A file may announce any size; beyond this many values (4 GB) it is refused unread.
constexpr std::uint64_t most_values = 1'000'000'000;

/// Libraries' messages can span lines; ours do not.
std::string one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    while (!text.empty() && text.back() == ' ') text.pop_back();
    return text.empty() ? "unknown reason" : text;
}

void check_size(const std::string& path, const OIIO::ImageSpec& spec) {
    const auto width = static_cast<std::uint64_t>(std::max(spec.full_width, spec.width));
    const auto height = static_cast<std::uint64_t>(std::max(spec.full_height, spec.height));
    if (spec.width < 1 || spec.height < 1 || spec.full_width < 1 || spec.full_height < 1 ||
        spec.depth > 1) {
        throw ImageError(path, "the picture has no pixels or is a volume", "give a 2D picture");
    }
    if (width * height * static_cast<std::uint64_t>(spec.nchannels) > most_values) {
        throw ImageError(path,
                         fmt::format("{} x {} pixels of {} channels are too large", width, height,
                                     spec.nchannels),
                         fmt::format("at most {} values are read", most_values));
    }
}

/// Integers of EXR files are counts and numbers (objects, samples); those of other formats are what
/// a display shows.
bool holds_display_values(const OIIO::ImageInput& file, const OIIO::ImageSpec& spec) {
    return !spec.format.is_floating_point() && std::string(file.format_name()) != "openexr";
}

/// OpenImageIO scales integers to [0,1] when asked for floats: 32-bit numbers are scaled back.
float as_stored(float value, OIIO::TypeDesc type) {
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

/// Copies channel `c` of a part's values to its place in the frame; what lies outside of the frame
/// is not part of the picture, and what the part does not cover stays 0.
void place_channel(const OIIO::ImageSpec& spec, const std::vector<float>& values, int c,
                   bool decode, int width, int height, std::span<float> target) {
    const auto channels = static_cast<std::size_t>(spec.nchannels);
    const int left = spec.x - spec.full_x;
    const int top = spec.y - spec.full_y;
    const int first = std::max(0, -left);
    const int last = std::min(spec.width, width - left);
    for (int y = std::max(0, -top); y < std::min(spec.height, height - top); ++y) {
        const std::size_t from = static_cast<std::size_t>(y) * static_cast<std::size_t>(spec.width);
        const std::size_t to = static_cast<std::size_t>(y + top) * static_cast<std::size_t>(width);
        for (int x = first; x < last; ++x) {
            const float value = as_stored(values[(from + static_cast<std::size_t>(x)) * channels +
                                                 static_cast<std::size_t>(c)],
                                          spec.channelformat(c));
            target[to + static_cast<std::size_t>(x + left)] =
                decode ? linear_from_srgb(value) : value;
        }
    }
}

/// Reads one part of the file into the channels that `image` lacks.
void read_part(OIIO::ImageInput& file, int part, Image& image) {
    const OIIO::ImageSpec spec = file.spec(part);
    check_size(image.source, spec);
    if (spec.full_width != image.width() || spec.full_height != image.height()) {
        std::string& left_out = image.metadata["plumbline:left_out"];
        left_out += fmt::format("{}part {} ({}x{})", left_out.empty() ? "" : ", ", part,
                                spec.full_width, spec.full_height);
        return;
    }
    const std::size_t count =
        static_cast<std::size_t>(spec.image_pixels()) * static_cast<std::size_t>(spec.nchannels);
    std::vector<float> values(count);
    if (!file.read_image(part, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, values.data())) {
        throw ImageError(image.source, "the pixels cannot be read: " + one_line(file.geterror()),
                         "write the file again");
    }
    const bool encoded = holds_display_values(file, spec);
    for (int c = 0; c < spec.nchannels; ++c) {
        const std::string name = name_in_image(spec, part, spec.channel_name(c), image);
        if (image.has_channel(name)) continue;
        place_channel(spec, values, c, encoded && c != spec.alpha_channel, image.width(),
                      image.height(), image.channel(name));
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

/// Writes `values`, `spec.nchannels` a pixel, or throws ImageError about `path`.
void write_pixels(const std::filesystem::path& path, const std::filesystem::path& temporary,
                  const OIIO::ImageSpec& spec, const void* values) {
    const auto file = OIIO::ImageOutput::create(temporary.string());
    const auto fail = [&](const std::string& reason) {
        throw ImageError(path.string(), "the picture cannot be written: " + one_line(reason),
                         "check that the folder exists, may be written to, and has room");
    };
    if (!file) fail(OIIO::geterror());
    if (!file->open(temporary.string(), spec)) fail(file->geterror());
    if (!file->write_image(spec.format, values)) fail(file->geterror());
    if (!file->close()) fail(file->geterror());
}

}  // namespace

Image read_image(const std::filesystem::path& path) {
    if (!std::filesystem::is_regular_file(path)) {
        throw ImageError(path.string(), "no such file", "name an image file");
    }
    OIIO::ImageSpec as_is;
    as_is.attribute("oiio:UnassociatedAlpha", 1);  // colours as stored, never times alpha
    const auto file = OIIO::ImageInput::open(path.string(), &as_is);
    if (!file) {
        throw ImageError(path.string(), "not a readable picture: " + one_line(OIIO::geterror()),
                         "give an EXR, PFM, HDR, PNG or JPEG file");
    }
    const OIIO::ImageSpec first = file->spec();
    check_size(path.string(), first);
    Image image(first.full_width, first.full_height);
    image.source = path.string();
    read_metadata(first, image);
    for (int part = 0; file->seek_subimage(part, 0); ++part) read_part(*file, part, image);
    return image;
}

void write_exr(const std::filesystem::path& path, const Image& image) {
    if (path.extension() != ".exr") {
        throw ImageError(path.string(), "not an EXR file name", "let it end in .exr");
    }
    const std::vector<std::string> names = image.channel_names();
    OIIO::ImageSpec spec(image.width(), image.height(), static_cast<int>(names.size()),
                         OIIO::TypeDesc::FLOAT);
    spec.channelnames = names;
    spec.attribute("compression", "zip");
    for (const auto& [key, value] : image.metadata) spec.attribute(key, value);
    std::vector<float> values(image.pixels() * names.size());
    for (std::size_t c = 0; c < names.size(); ++c) {
        const std::span<const float> channel = image.channel(names[c]);
        for (std::size_t i = 0; i < channel.size(); ++i) values[i * names.size() + c] = channel[i];
    }
    write_whole(path, [&](const std::filesystem::path& temporary) {
        write_pixels(path, temporary, spec, values.data());
    });
}

void write_png(const std::filesystem::path& path, int width, int height,
               std::span<const unsigned char> rgb) {
    const OIIO::ImageSpec spec(width, height, 3, OIIO::TypeDesc::UINT8);
    write_whole(path, [&](const std::filesystem::path& temporary) {
        write_pixels(path, temporary, spec, rgb.data());
    });
}

}  // namespace plumbline
