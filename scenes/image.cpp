// SPDX-License-Identifier: Apache-2.0
#include "scenes/image.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scenes/errors.h"

namespace plumbline {
namespace {

constexpr std::array<const char*, 3> rgb = {"R", "G", "B"};

std::string shown(const std::string& layer) { return layer.empty() ? "radiance (R, G, B)" : layer; }

}  // namespace

std::string channel_name(const std::string& layer, const std::string& c) {
    return layer.empty() ? c : layer + "." + c;
}

Image::Image(int width, int height) : width_(width), height_(height) {}

std::span<float> Image::channel(const std::string& name) {
    std::vector<float>& values = channels_[name];
    values.resize(pixels());
    return values;
}

std::span<const float> Image::channel(const std::string& name) const {
    const auto found = channels_.find(name);
    if (found == channels_.end()) {
        throw ImageError(source.empty() ? "image" : source, fmt::format("no channel '{}'", name),
                         fmt::format("it has {}", fmt::join(channel_names(), ", ")));
    }
    return found->second;
}

std::vector<std::string> Image::channel_names() const {
    std::vector<std::string> names;
    for (const auto& [name, values] : channels_) names.push_back(name);
    return names;
}

std::array<std::span<float>, 3> Image::layer(const std::string& name) {
    std::array<std::span<float>, 3> result;
    for (std::size_t c = 0; c < 3; ++c) result[c] = channel(channel_name(name, rgb[c]));
    return result;
}

std::array<std::span<const float>, 3> Image::layer(const std::string& name) const {
    if (!has_layer(name)) {
        std::vector<std::string> names = layer_names();
        std::transform(names.begin(), names.end(), names.begin(), shown);
        throw ImageError(
            source.empty() ? "image" : source, fmt::format("no layer '{}'", shown(name)),
            names.empty() ? fmt::format("it has the channels {}", fmt::join(channel_names(), ", "))
                          : fmt::format("it has {}", fmt::join(names, ", ")));
    }
    std::array<std::span<const float>, 3> result;
    for (std::size_t c = 0; c < 3; ++c) result[c] = channel(channel_name(name, rgb[c]));
    return result;
}

bool Image::has_layer(const std::string& name) const {
    return std::all_of(rgb.begin(), rgb.end(),
                       [&](const char* c) { return has_channel(channel_name(name, c)); });
}

std::vector<std::string> Image::layer_names() const {
    std::vector<std::string> names;
    if (has_layer("")) names.emplace_back();
    for (const auto& [name, values] : channels_) {
        if (!name.ends_with(".R")) continue;
        const std::string layer = name.substr(0, name.size() - 2);
        if (has_layer(layer)) names.push_back(layer);
    }
    return names;
}

float srgb_from_linear(float linear) {
    if (linear <= 0.0031308f) return 12.92f * linear;
    return 1.055f * std::pow(linear, 1.f / 2.4f) - 0.055f;
}

float linear_from_srgb(float encoded) {
    if (encoded <= 0.04045f) return encoded / 12.92f;
    return std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

}  // namespace plumbline
