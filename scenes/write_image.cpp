// SPDX-License-Identifier: Apache-2.0
#include <OpenImageIO/imageio.h>

#include "scenes/errors.h"
#include "scenes/image.h"
#include "scenes/printable.h"
#include "scenes/whole_file.h"

namespace plumbline {
namespace {

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
