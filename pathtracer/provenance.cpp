// SPDX-License-Identifier: Apache-2.0
#include "pathtracer/provenance.h"

#include <fmt/core.h>

#include "pathtracer/digest.h"
#include "scenes/effects.h"
#include "scenes/errors.h"
#include "scenes/number_pair.h"
#include "scenes/write_json.h"

namespace plumbline::pathtracer {
namespace {

/// Of all but the size of the picture, which is an entry of its own.
std::uint64_t digest_of(Scene scene) {
    Digest digest;
    for (Mesh& mesh : scene.meshes) {
        // As numbers: millions of triangles make a long text.
        digest.add(std::span<const glm::vec3>(mesh.positions));
        digest.add(std::span<const Spectrum>(mesh.vertex_albedo));
        digest.add(std::span<const glm::vec2>(mesh.texcoords));
        digest.add(std::span<const glm::uvec3>(mesh.triangles));
        digest.add(std::span<const int>(mesh.triangle_materials));
        Mesh name_only;
        name_only.name = std::move(mesh.name);
        mesh = std::move(name_only);
    }
    for (const Material& material : scene.materials) {
        if (!material.texture) continue;
        digest.add(std::span<const Spectrum>(material.texture->picture->albedo));
    }
    if (scene.environment_image) {
        digest.add(std::span<const Spectrum>(scene.environment_image->panorama->radiance));
    }
    scene.camera.width = scene.camera.height = 1;
    digest.add(json_of(scene).dump());
    return digest.value();
}

std::string options_text(const RenderOptions& options) {
    std::string text = "max_bounces=";
    text += options.max_bounces ? std::to_string(*options.max_bounces) : "unlimited";
    if (options.adaptive) text += " adaptive";
    if (options.seconds) return text + fmt::format(" time={}", *options.seconds);
    if (options.target_relmse)
        return text + fmt::format(" target_relmse={}", *options.target_relmse);
    return text + fmt::format(" spp={}", options.spp);
}

std::string effects_text(const Scene& scene) {
    std::string text;
    for (const EffectReason& reason : effect_reasons(scene)) {
        if (!reason.simulated) continue;
        text += text.empty() ? reason.effect : ", " + reason.effect;
    }
    return text;
}

std::string value_of(const Provenance& provenance, const std::string& key) {
    const auto found = provenance.find(key);
    return found == provenance.end() ? "unknown" : found->second;
}

}  // namespace

Provenance provenance_of(const Scene& scene, int frame, const RenderOptions& options) {
    Provenance provenance = {
        {"plumbline:renderer", "pathtracer"},
        {"plumbline:version", PLUMBLINE_VERSION},
        {"plumbline:scene", scene.name},
        {"plumbline:digest", fmt::format("{:016x}", digest_of(scene))},
        {"plumbline:frame", std::to_string(frame)},
        {"plumbline:size", fmt::format("{}x{}", scene.camera.width, scene.camera.height)},
        {"plumbline:seed", std::to_string(options.seed)},
        {"plumbline:options", options_text(options)},
        {"plumbline:effects", effects_text(scene)},
    };
    if (options.shard.count > 1) provenance["plumbline:shard"] = shard_text(options.shard);
    return provenance;
}

std::optional<std::string> difference(const Provenance& its, const Provenance& expected) {
    // The digest last: of two scenes with one name it can only say that they differ.
    for (const std::string name : {"renderer", "version", "scene", "frame", "size", "seed",
                                   "options", "effects", "digest"}) {
        const std::string key = "plumbline:" + name;
        const std::string is = value_of(its, key);
        const std::string should_be = value_of(expected, key);
        if (is == should_be) continue;
        if (name == "digest") return "its scene has the same name and another content";
        return fmt::format("its {} {} '{}', not '{}'", name, name.ends_with('s') ? "are" : "is", is,
                           should_be);
    }
    return std::nullopt;
}

std::string shard_text(const Shard& shard) {
    return fmt::format("{}/{}", shard.index, shard.count);
}

Shard parsed_shard(const std::string& where, const std::string& text) {
    const auto shard = parsed_pair(text, '/');
    if (!shard || shard->x > shard->y) {
        throw UsageError(where, fmt::format("'{}' is not a shard", text),
                         "give I/N, such as 1/4 to 4/4");
    }
    return {.index = shard->x, .count = shard->y};
}

}  // namespace plumbline::pathtracer
