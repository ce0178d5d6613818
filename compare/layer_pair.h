// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scenes/image.h"

namespace plumbline::compare {

/// A place in a picture, in pixels from the top left corner.
struct PixelPosition {
    int x;
    int y;
};

/// One layer of two pictures of the same size, and which of its pixels can be measured.
///
/// A value that is not finite would spoil every mean that it enters, so its whole pixel is left
/// out of all figures; how many such values there are, and where the first is, is kept here.
struct LayerPair {
    std::string layer;  ///< "" is radiance
    int width = 0;
    int height = 0;
    std::array<std::span<const float>, 3> reference;  ///< R, G, B
    std::array<std::span<const float>, 3> test;
    std::vector<std::uint8_t> usable;  ///< one a pixel: 1 if all six values are finite
    std::size_t usable_pixels = 0;
    std::size_t non_finite = 0;  ///< values, in either picture
    std::optional<PixelPosition> first_non_finite;

    std::size_t pixels() const { return usable.size(); }
};

/// Pairs a layer of two images, which must outlive the result.
/// Throws ImageError if the sizes differ, a layer is missing, or no pixel is finite in both.
LayerPair pair_layers(const Image& reference, const Image& test, const std::string& layer);

}  // namespace plumbline::compare
