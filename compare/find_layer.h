// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>

#include "scenes/image.h"

namespace plumbline::compare {

/// Three channels of an image, by whichever names its maker chose.
struct FoundLayer {
    std::array<std::span<const float>, 3> channels;
    std::array<std::string, 3> names;  ///< three times the same: the layer is one channel
};

/// The layer NAME ("" is radiance) as channels NAME.R, .G, .B; or .r .g .b, .red .green .blue,
/// .X .Y .Z, .x .y .z; or NAME.Y, NAME.Z or NAME itself: one channel, which then counts as three
/// equal ones. Radiance without R, G, B may also be the only layer there is, such as
/// `ViewLayer.Combined`. None if the image has no such layer.
std::optional<FoundLayer> find_layer_if_there(const Image& image, const std::string& name);

/// The same; throws ImageError that lists what there is.
FoundLayer find_layer(const Image& image, const std::string& name);

}  // namespace plumbline::compare
