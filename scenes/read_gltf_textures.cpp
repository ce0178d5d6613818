// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "scenes/gltf_json.h"
#include "scenes/percent_encoding.h"
#include "scenes/read_gltf.h"

namespace plumbline {
namespace {

/// A picture needs an ending by which its format is known; one within a glTF file has a type.
std::string picture_name(int index, bool jpeg) {
    return fmt::format("picture-{}.{}", index, jpeg ? "jpg" : "png");
}

std::shared_ptr<const Picture> read_image_of(const JsonView& image, int index,
                                             GltfBeingRead& gltf) {
    const auto uri = image.find("uri");
    if (!uri) {
        const JsonView view = image.at("bufferView");
        const auto type = image.find("mimeType");
        return decode_picture(gltf.accessors.view_bytes(view),
                              picture_name(index, type && type->text() == "image/jpeg"),
                              view.place());
    }
    const std::string text = uri->text();
    const bool embedded = text.starts_with("data:");
    return decode_picture(load_uri(*uri, gltf.folder),
                          embedded
                              ? picture_name(index, text.starts_with("data:image/jpeg"))
                              : std::filesystem::path(percent_decoded(text)).filename().string(),
                          uri->place());
}

Wrap wrap_of(const JsonView& sampler, const std::string& key) {
    const auto given = sampler.find(key);
    if (!given) return Wrap::Repeat;
    const int number = given->integer(0);
    for (std::size_t i = 0; i < gltf_wraps.size(); ++i) {
        if (gltf_wraps[i] == number) return static_cast<Wrap>(i);
    }
    given->fail(fmt::format("is {}", number), "a wrap is 10497, 33648 or 33071");
}

}  // namespace

Texture read_gltf_texture(const JsonView& reference, GltfBeingRead& gltf) {
    const auto textures = gltf.root.items("textures");
    const auto images = gltf.root.items("images");
    const auto samplers = gltf.root.items("samplers");
    if (const auto set = reference.find("texCoord"); set && set->integer(0) != 0) {
        set->fail(fmt::format("is {}", set->integer(0)),
                  "only the first set of texture coordinates, 0, is read");
    }
    const JsonView texture =
        textures[std::size_t(reference.at("index").index(textures.size(), "texture"))];
    const int index = texture.at("source").index(images.size(), "image");
    std::shared_ptr<const Picture>& picture = gltf.pictures[index];
    if (!picture) picture = read_image_of(images[std::size_t(index)], index, gltf);
    Texture result{picture};
    if (const auto sampler = texture.find("sampler")) {
        const JsonView item = samplers[std::size_t(sampler->index(samplers.size(), "sampler"))];
        result.wrap_u = wrap_of(item, "wrapS");
        result.wrap_v = wrap_of(item, "wrapT");
    }
    return result;
}

}  // namespace plumbline
