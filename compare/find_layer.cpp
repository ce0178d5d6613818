// SPDX-License-Identifier: Apache-2.0
#include "compare/find_layer.h"

#include <fmt/format.h>

#include <set>
#include <vector>

#include "scenes/errors.h"

namespace plumbline::compare {

namespace {

using Names = std::array<std::string, 3>;

/// What the three channels of a layer are called, the most usual first.
const std::array<Names, 5> triples{
    {{"R", "G", "B"}, {"r", "g", "b"}, {"red", "green", "blue"}, {"X", "Y", "Z"}, {"x", "y", "z"}}};
/// What the only channel of a layer is called: luminance, depth, and either in small letters.
const std::array<std::string, 4> singles{"Y", "Z", "y", "z"};

std::optional<FoundLayer> found(const Image& image, const Names& names) {
    for (const std::string& name : names)
        if (!image.has_channel(name)) return std::nullopt;
    return FoundLayer{{image.channel(names[0]), image.channel(names[1]), image.channel(names[2])},
                      names};
}

std::optional<FoundLayer> by_name(const Image& image, const std::string& layer) {
    for (const Names& triple : triples)
        if (auto it = found(image, {channel_name(layer, triple[0]), channel_name(layer, triple[1]),
                                    channel_name(layer, triple[2])}))
            return it;
    for (const std::string& single : singles) {
        const std::string name = channel_name(layer, single);
        if (auto it = found(image, {name, name, name})) return it;
    }
    return found(image, {layer, layer, layer});
}

/// Names before the last dot; "" for channels without one.
std::set<std::string> layers_of(const Image& image) {
    std::set<std::string> layers;
    for (const std::string& channel : image.channel_names()) {
        const std::size_t dot = channel.rfind('.');
        layers.insert(dot == std::string::npos ? "" : channel.substr(0, dot));
    }
    return layers;
}

std::vector<std::string> shown_layers(const Image& image) {
    std::vector<std::string> shown;
    for (const std::string& layer : layers_of(image)) {
        std::string channels;
        for (const std::string& name : image.channel_names()) {
            const std::string prefix = layer.empty() ? "" : layer + ".";
            const bool of_layer =
                name.starts_with(prefix) && name.find('.', prefix.size()) == std::string::npos;
            if (of_layer) channels += (channels.empty() ? "" : " ") + name.substr(prefix.size());
        }
        shown.push_back(fmt::format("{} ({})", layer.empty() ? "radiance" : layer, channels));
    }
    return shown;
}

}  // namespace

std::optional<FoundLayer> find_layer_if_there(const Image& image, const std::string& name) {
    if (auto layer = by_name(image, name)) return layer;
    const std::set<std::string> layers = layers_of(image);
    if (!name.empty() || layers.size() != 1) return std::nullopt;
    return by_name(image, *layers.begin());
}

FoundLayer find_layer(const Image& image, const std::string& name) {
    if (auto layer = find_layer_if_there(image, name)) return *std::move(layer);
    throw ImageError(image.source.empty() ? "image" : image.source,
                     fmt::format("no layer '{}'", name.empty() ? "radiance (R, G, B)" : name),
                     fmt::format("name one of its layers with --layer: {}",
                                 fmt::join(shown_layers(image), ", ")));
}

}  // namespace plumbline::compare
