// SPDX-License-Identifier: Apache-2.0
#include "compare/layer_pair.h"

#include <fmt/format.h>

#include <cmath>

#include "scenes/errors.h"

namespace plumbline::compare {

namespace {

void require_same_size(const Image& reference, const Image& test) {
    if (reference.width() == test.width() && reference.height() == test.height()) return;
    throw ImageError(test.source.empty() ? "test image" : test.source,
                     fmt::format("is {}x{} but the reference is {}x{}", test.width(), test.height(),
                                 reference.width(), reference.height()),
                     "render both at the same --size");
}

}  // namespace

LayerPair pair_layers(const Image& reference, const Image& test, const std::string& layer) {
    require_same_size(reference, test);
    LayerPair pair;
    pair.layer = layer;
    pair.width = reference.width();
    pair.height = reference.height();
    pair.reference = reference.layer(layer);
    pair.test = test.layer(layer);
    pair.usable.assign(reference.pixels(), 1);
    for (std::size_t i = 0; i < pair.usable.size(); ++i) {
        std::size_t bad = 0;
        for (std::size_t c = 0; c < 3; ++c)
            bad += std::size_t(!std::isfinite(pair.reference[c][i])) +
                   std::size_t(!std::isfinite(pair.test[c][i]));
        if (bad == 0) {
            ++pair.usable_pixels;
            continue;
        }
        pair.usable[i] = 0;
        pair.non_finite += bad;
        const std::size_t width = std::size_t(pair.width);
        if (!pair.first_non_finite)
            pair.first_non_finite = PixelPosition{int(i % width), int(i / width)};
    }
    if (pair.usable_pixels == 0)
        throw ImageError(test.source.empty() ? "test image" : test.source,
                         "no pixel is finite in both images",
                         "a comparison needs at least one finite pixel");
    return pair;
}

}  // namespace plumbline::compare
