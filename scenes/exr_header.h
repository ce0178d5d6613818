// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace plumbline {

/// What the headers of an EXR file say before anything is decoded.
struct ExrHeader {
    /// What is wrong with the sizes of attributes, in words; empty if nothing is.
    std::string fault;
    /// Values in a row, over all channels, of the part that has the most.
    std::uint64_t values_in_row = 0;
    /// Values in a tile, over all channels, of the part that has the most; 0 if none is tiled.
    std::uint64_t values_in_tile = 0;
};

/// Walks over all attributes ("OpenEXR File Layout" of its documentation).
///
/// OpenEXR makes room for whatever size an attribute announces, up to 2 GB, before it reads. It
/// reads those of known types without a look at the size, so that a wrong one makes it take what
/// follows for the next attribute, of any size again; its core library lets some of both pass. And
/// it makes room for up to 256 rows, or for several tiles, as soon as it knows how large they are,
/// however small the picture.
ExrHeader read_exr_header(const std::filesystem::path& path);

}  // namespace plumbline
