// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <random>

#include "scenes/image.h"

namespace plumbline::compare {

/// An image whose radiance at (x, y, channel) is what `value` returns.
inline Image image_of(int width, int height, const std::function<float(int, int, int)>& value) {
    Image image(width, height);
    const auto layer = image.layer("");
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c)
                layer[std::size_t(c)][std::size_t(y * width + x)] = value(x, y, c);
    return image;
}

/// Values that differ at every pixel and channel, between 0 and `largest`.
inline Image noise_image(int width, int height, unsigned seed, float largest) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(0.f, largest);
    return image_of(width, height, [&](int, int, int) { return uniform(random); });
}

}  // namespace plumbline::compare
