// SPDX-License-Identifier: Apache-2.0
#include "scenes/texture.h"

#include <fmt/format.h>
#include <stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "scenes/errors.h"
#include "scenes/image.h"
#include "scenes/input_files.h"
#include "scenes/whole_file.h"

namespace plumbline {
namespace {

/// A folder of its own, gone with all that is in it.
class ScratchFolder {
 public:
    ScratchFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "plumbline-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) {
            throw ImageError(name, "no folder can be made here", "set TMPDIR to one with room");
        }
        path_ = name;
    }
    ~ScratchFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

 private:
    std::filesystem::path path_;
};

/// The library's image readers want a file; those of all formats that glTF embeds read no memory.
Image decoded(const std::string& bytes, const std::string& name, const std::string& source) {
    const ScratchFolder folder;
    const std::filesystem::path file = folder.path() / name;
    write_text(file, bytes);
    try {
        return read_image(file);
    } catch (const ImageError& error) {
        // In the user's words for it, not by the name of the scratch file.
        std::string line = error.what();
        const std::size_t at = line.find(file.string());
        if (at != std::string::npos) line.replace(at, file.string().size(), source);
        throw ImageError(line);
    }
}

int wrapped(int i, int size, Wrap wrap) {
    if (wrap == Wrap::Clamp) return std::clamp(i, 0, size - 1);
    const int period = wrap == Wrap::Mirror ? 2 * size : size;
    const int in_period = ((i % period) + period) % period;
    return in_period < size ? in_period : period - 1 - in_period;
}

/// The pixels on both sides of a place along an axis, and the share of the second.
struct Between {
    int first, second;
    float share;
};

Between between(float place, int size, Wrap wrap) {
    // Whole turns taken off first: far from 0 a float has no digits left for the pixels.
    const float turns = wrap == Wrap::Clamp ? 0.f : 2.f * std::floor(place / 2.f);
    const float limited = wrap == Wrap::Clamp ? std::clamp(place, 0.f, 1.f) : place - turns;
    const float x = limited * static_cast<float>(size) - .5f;
    const float below = std::floor(x);
    const int i = static_cast<int>(below);
    return {wrapped(i, size, wrap), wrapped(i + 1, size, wrap), x - below};
}

}  // namespace

bool Picture::operator==(const Picture& other) const {
    return width == other.width && height == other.height && albedo == other.albedo;
}

bool Texture::operator==(const Texture& other) const {
    return wrap_u == other.wrap_u && wrap_v == other.wrap_v && *picture == *other.picture;
}

Spectrum Texture::at(const glm::vec2& uv) const {
    const Between x = between(uv.x, picture->width, wrap_u);
    const Between y = between(uv.y, picture->height, wrap_v);
    const auto pixel = [&](int column, int row) {
        return picture
            ->albedo[std::size_t(row) * std::size_t(picture->width) + std::size_t(column)];
    };
    return glm::mix(glm::mix(pixel(x.first, y.first), pixel(x.second, y.first), x.share),
                    glm::mix(pixel(x.first, y.second), pixel(x.second, y.second), x.share),
                    y.share);
}

std::shared_ptr<const Picture> decode_picture(std::string bytes, const std::string& name,
                                              const std::string& source) {
    const Image image = decoded(bytes, name, source);
    auto picture = std::make_shared<Picture>();
    picture->name = name;
    picture->encoded = std::move(bytes);
    picture->width = image.width();
    picture->height = image.height();
    picture->albedo.resize(image.pixels());
    // One channel is a grey picture.
    const bool grey = !image.has_layer("") && image.channel_names().size() == 1;
    const auto one = [&] { return image.channel(image.channel_names().front()); };
    const auto rgb = grey ? std::array{one(), one(), one()} : image.layer("");
    for (std::size_t i = 0; i < image.pixels(); ++i) {
        const Spectrum albedo(rgb[0][i], rgb[1][i], rgb[2][i]);
        // The negation also catches NaN.
        if (!(min_component(albedo) >= 0.f && max_component(albedo) <= 1.f)) {
            const auto width = std::size_t(image.width());
            throw SceneError(
                source, fmt::format("its pixel ({}, {}) is outside [0, 1]", i % width, i / width),
                "albedo is a share of the light that falls on a surface");
        }
        picture->albedo[i] = albedo;
    }
    return picture;
}

std::shared_ptr<const Picture> read_picture(const std::filesystem::path& file) {
    return decode_picture(read_bytes(file), file.filename().string(), file.string());
}

}  // namespace plumbline
