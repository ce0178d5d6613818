// SPDX-License-Identifier: Apache-2.0
#include "reports/shrink.h"

#include <algorithm>

#include "compare/noise.h"

namespace plumbline::reports {

namespace {

void shrink_layer(const Image& from, const std::string& layer, int block, float scale, Image& to) {
    if (!from.has_layer(layer)) return;
    const auto source = from.layer(layer);
    const auto target = to.layer(layer);
    for (std::size_t c = 0; c < source.size(); ++c) {
        const std::vector<float> means = block_means(source[c], from.width(), from.height(), block);
        std::transform(means.begin(), means.end(), target[c].begin(),
                       [scale](float mean) { return scale * mean; });
    }
}

}  // namespace

std::vector<float> block_means(std::span<const float> plane, int width, int height, int block) {
    std::vector<float> means;
    for (int top = 0; top < height; top += block) {
        for (int left = 0; left < width; left += block) {
            const int right = std::min(left + block, width);
            const int bottom = std::min(top + block, height);
            double sum = 0;
            for (int y = top; y < bottom; ++y)
                for (int x = left; x < right; ++x)
                    sum += plane[std::size_t(y) * std::size_t(width) + std::size_t(x)];
            means.push_back(static_cast<float>(sum / ((right - left) * (bottom - top))));
        }
    }
    return means;
}

Image shrunk(const Image& image, int block) {
    Image small(blocks(image.width(), block), blocks(image.height(), block));
    const float pixels = static_cast<float>(block) * static_cast<float>(block);
    for (const char* layer : {"", "indirect"}) {
        shrink_layer(image, layer, block, 1.f, small);
        shrink_layer(image, compare::variance_layer(layer), block, 1.f / pixels, small);
    }
    return small;
}

}  // namespace plumbline::reports
