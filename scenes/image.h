// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "scenes/geometry.h"

namespace plumbline {

/// A picture of named 32-bit float channels, row by row from the top left.
///
/// A layer is three channels: "" is radiance (R, G, B); "direct" is direct.R, direct.G, direct.B.
class Image {
 public:
    Image(int width, int height);

    int width() const { return width_; }
    int height() const { return height_; }
    std::size_t pixels() const { return std::size_t(width_) * std::size_t(height_); }

    /// The channel of this name, made of zeros if there was none. Spans stay valid until the
    /// image is assigned to or destroyed.
    std::span<float> channel(const std::string& name);
    /// The channel of this name. Throws ImageError that lists what there is if there is none.
    std::span<const float> channel(const std::string& name) const;
    bool has_channel(const std::string& name) const { return channels_.contains(name); }
    std::vector<std::string> channel_names() const;

    /// The channels R, G, B of a layer, made of zeros if there were none.
    std::array<std::span<float>, 3> layer(const std::string& name);
    /// The same to read. Throws ImageError that lists the layers there are if it is not there.
    std::array<std::span<const float>, 3> layer(const std::string& name) const;
    bool has_layer(const std::string& name) const;
    /// Names of all layers with R, G and B, radiance first as "".
    std::vector<std::string> layer_names() const;

    /// Header entries: how the file was made (scene, frame, seed, options, ...).
    std::map<std::string, std::string> metadata;
    /// Where it was read from, for messages.
    std::string source;

 private:
    int width_;
    int height_;
    std::map<std::string, std::vector<float>> channels_;
};

/// The name of channel `c` ("R", "G" or "B") of a layer.
std::string channel_name(const std::string& layer, const std::string& c);

/// Reads any file that OpenImageIO reads; the picture is the file's display window, 0 where the
/// data window does not reach.
///
/// All channels of an EXR go by their names; those of a further part that have no layer of their
/// own, or a name that is taken, by PART.CHANNEL. Parts of another size than the first are not
/// read, which metadata["plumbline:left_out"] then says. 8- and 16-bit files are decoded from sRGB
/// to linear, which metadata["plumbline:decoded"] then says; alpha is not, and does not touch
/// colours. Throws ImageError if the file is missing, broken or too large to hold.
Image read_image(const std::filesystem::path& path);

/// Writes all channels and the metadata as a 32-bit float EXR, whole or not at all.
/// Throws ImageError.
void write_exr(const std::filesystem::path& path, const Image& image);

/// Writes 8-bit RGB, `rgb` holding width * height * 3 bytes, whole or not at all.
/// Throws ImageError.
void write_png(const std::filesystem::path& path, int width, int height,
               std::span<const unsigned char> rgb);

/// The sRGB transfer function [IEC 61966-2-1]: linear in [0,1] to display in [0,1].
float srgb_from_linear(float linear);
float linear_from_srgb(float encoded);

}  // namespace plumbline
