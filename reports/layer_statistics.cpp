// SPDX-License-Identifier: Apache-2.0
#include "reports/layer_statistics.h"

#include <algorithm>
#include <cmath>

#include "compare/noise.h"

namespace plumbline::reports {

namespace {

std::vector<float> finite_values(const Image& image, const std::string& layer) {
    std::vector<float> values;
    for (const std::span<const float> channel : image.layer(layer))
        std::copy_if(channel.begin(), channel.end(), std::back_inserter(values),
                     [](float value) { return std::isfinite(value); });
    return values;
}

}  // namespace

double layer_mean(const Image& image, const std::string& layer) {
    const std::vector<float> values = finite_values(image, layer);
    double sum = 0;
    for (const float value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

double layer_noise(const Image& image, const std::string& layer) {
    return std::sqrt(layer_mean(image, compare::variance_layer(layer)));
}

double layer_percentile(const Image& image, const std::string& layer, double share) {
    std::vector<float> values = finite_values(image, layer);
    if (values.empty()) return 0;
    const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + rank, values.end());
    return values[static_cast<std::size_t>(rank)];
}

}  // namespace plumbline::reports
