// SPDX-License-Identifier: Apache-2.0
#include "compare/layer_pair.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/find_layer.h"
#include "scenes/errors.h"

namespace plumbline::compare {

namespace {

/// Linear value from which a mask counts a pixel in.
constexpr float mask_threshold = 0.5f;

std::string name_of(const Image& image, const char* role) {
    return image.source.empty() ? role : image.source;
}

void require_same_size(const Image& reference, const Image& other, const char* role) {
    if (reference.width() == other.width() && reference.height() == other.height()) return;
    throw ImageError(name_of(other, role),
                     fmt::format("is {}x{} but the reference is {}x{}", other.width(),
                                 other.height(), reference.width(), reference.height()),
                     "render both at the same --size, or compare with --resample");
}

void find_finite(LayerPair& pair) {
    pair.finite.assign(pair.reference[0].size(), 1);
    for (std::size_t i = 0; i < pair.finite.size(); ++i) {
        std::size_t bad = 0;
        for (std::size_t c = 0; c < 3; ++c)
            bad += std::size_t(!std::isfinite(pair.reference[c][i])) +
                   std::size_t(!std::isfinite(pair.test[c][i]));
        if (bad == 0) continue;
        pair.finite[i] = 0;
        pair.non_finite += bad;
        const std::size_t width = std::size_t(pair.width);
        if (!pair.first_non_finite)
            pair.first_non_finite = PixelPosition{int(i % width), int(i / width)};
    }
}

void apply_mask(const Image& mask, LayerPair& pair) {
    const auto channels = find_layer(mask, "").channels;
    for (std::size_t i = 0; i < pair.usable.size(); ++i)
        if (!((channels[0][i] + channels[1][i] + channels[2][i]) / 3.f >= mask_threshold))
            pair.usable[i] = 0;
}

}  // namespace

LayerPair pair_layers(const Image& reference, const Image& test, const std::string& layer,
                      const Image* mask) {
    require_same_size(reference, test, "test image");
    LayerPair pair;
    pair.layer = layer;
    pair.width = reference.width();
    pair.height = reference.height();
    const FoundLayer r = find_layer(reference, layer);
    pair.names = r.names;
    pair.reference = r.channels;
    pair.test = find_layer(test, layer).channels;
    find_finite(pair);
    pair.usable = pair.finite;
    if (mask) {
        require_same_size(reference, *mask, "mask");
        apply_mask(*mask, pair);
    }
    pair.usable_pixels = std::size_t(std::count(pair.usable.begin(), pair.usable.end(), 1));
    if (pair.usable_pixels == 0)
        throw ImageError(name_of(test, "test image"),
                         mask ? "no pixel inside the mask is finite in both images"
                              : "no pixel is finite in both images",
                         "a comparison needs at least one finite pixel");
    return pair;
}

}  // namespace plumbline::compare
