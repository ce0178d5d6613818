// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "scenes/nearest_name.h"
#include "scenes/read_gltf.h"

namespace plumbline {
namespace {

double number_or(const JsonView& item, const std::string& key, double otherwise) {
    const auto member = item.find(key);
    return member ? member->number() : otherwise;
}

/// Multiplies in double, so that a value that was split into two factors comes back exactly.
Spectrum scaled(const std::vector<double>& values, double scale) {
    return {static_cast<float>(values[0] * scale), static_cast<float>(values[1] * scale),
            static_cast<float>(values[2] * scale)};
}

/// Reads what a Lambert surface has of the metallic-roughness model, and notes the rest.
void read_reflection(const JsonView& pbr, Material& material, GltfBeingRead& gltf) {
    if (const auto base = pbr.find("baseColorFactor")) {
        material.albedo = scaled(base->numbers(4), 1.);
    }
    const std::string who = "material " + in_quotes(material.name) + ": ";
    if (const auto texture = pbr.find("baseColorTexture")) {
        material.texture = read_gltf_texture(*texture, gltf);
    }
    if (const double metallic = number_or(pbr, "metallicFactor", 1.); metallic != 0.) {
        gltf.note(who + fmt::format("metallic reflection ({:g}): the surface is taken as matt",
                                    metallic));
    }
}

void read_emission(const JsonView& item, Material& material) {
    const auto emissive = item.find("emissiveFactor");
    if (!emissive) return;
    const auto strength = extension(item, "KHR_materials_emissive_strength");
    material.emission =
        scaled(emissive->numbers(3), strength ? number_or(*strength, "emissiveStrength", 1.) : 1.);
}

}  // namespace

void read_gltf_materials(GltfBeingRead& gltf) {
    for (const JsonView& item : gltf.root.items("materials")) {
        Material material;
        const std::size_t index = gltf.scene.materials.size();
        material.name = gltf.material_names(item, "material", index);
        material.albedo = Spectrum(1.f);
        const std::string who = "material " + in_quotes(material.name) + ": ";
        if (const auto pbr = item.find("pbrMetallicRoughness")) {
            read_reflection(*pbr, material, gltf);
        }
        read_emission(item, material);
        if (const auto both = item.find("doubleSided")) material.two_sided = both->boolean();
        if (item.find("emissiveTexture")) gltf.note(who + "emission texture");
        if (item.find("normalTexture")) gltf.note(who + "normal map");
        if (const auto alpha = item.find("alphaMode"); alpha && alpha->text() != "OPAQUE") {
            gltf.note(who + "transparency");
        }
        gltf.scene.materials.push_back(std::move(material));
    }
}

}  // namespace plumbline
