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
/// out of all figures; how many such values there are, and where the first is, is kept here. So are
/// pixels outside of a mask, but filters that look at a pixel's surroundings see them.
struct LayerPair {
    std::string layer;                 ///< "" is radiance
    std::array<std::string, 3> names;  ///< of the reference's channels; equal if it is only one
    int width = 0;
    int height = 0;
    std::array<std::span<const float>, 3> reference;  ///< R, G, B
    std::array<std::span<const float>, 3> test;
    std::vector<std::uint8_t> finite;  ///< one a pixel: 1 if all six values are finite
    std::vector<std::uint8_t> usable;  ///< one a pixel: 1 if finite and inside the mask
    std::size_t usable_pixels = 0;
    std::size_t non_finite = 0;  ///< values, in either picture
    std::optional<PixelPosition> first_non_finite;

    std::size_t pixels() const { return usable.size(); }
};

/// Pairs a layer of two images, which must outlive the result.
/// `mask`: a picture of the same size whose pixels count where its radiance is at least 0.5 in the
/// mean of its channels; none: all do. Throws ImageError if the sizes differ, a layer is missing,
/// or no pixel is finite in both and inside the mask.
LayerPair pair_layers(const Image& reference, const Image& test, const std::string& layer,
                      const Image* mask = nullptr);

}  // namespace plumbline::compare
