// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "scenes/geometry.h"

namespace plumbline {

/// What lies beside a picture, along each of its axes [glTF 2.0, section 5.26].
enum class Wrap { Repeat, Mirror, Clamp };

/// A picture of albedo, decoded to linear.
struct Picture {
    std::string name;     ///< of its file, without folders
    std::string encoded;  ///< the file's bytes, to be written again as they are
    int width = 0;
    int height = 0;
    std::vector<Spectrum> albedo;  ///< in [0,1], row by row from the top left

    /// Files may have other names: what counts is what is seen.
    bool operator==(const Picture& other) const;
};

/// A picture spread over a mesh by its texture coordinates.
struct Texture {
    std::shared_ptr<const Picture> picture;  ///< never null
    Wrap wrap_u = Wrap::Repeat;
    Wrap wrap_v = Wrap::Repeat;

    bool operator==(const Texture& other) const;
    /// Albedo at a place: (0,0) is the top left of the picture, (1,1) its bottom right. Bilinear
    /// between the middles of pixels.
    Spectrum at(const glm::vec2& uv) const;
};

/// Decodes the bytes of a picture file, 8- and 16-bit ones from sRGB. `source` stands in messages;
/// the ending of `name` says which format it is. Throws ImageError, and SceneError if a value lies
/// outside [0,1].
std::shared_ptr<const Picture> decode_picture(std::string bytes, const std::string& name,
                                              const std::string& source);

/// The same for a file.
std::shared_ptr<const Picture> read_picture(const std::filesystem::path& file);

}  // namespace plumbline
