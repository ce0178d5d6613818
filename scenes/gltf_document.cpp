// SPDX-License-Identifier: Apache-2.0
#include "scenes/gltf_document.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>

#include "scenes/errors.h"
#include "scenes/input_files.h"
#include "scenes/nearest_name.h"
#include "scenes/percent_encoding.h"

namespace plumbline {
namespace {

const std::array<std::string, 3> supported_extensions = {
    "KHR_lights_punctual", "KHR_materials_emissive_strength", "KHR_mesh_quantization"};

/// A .glb's two chunks [glTF 2.0, section 4.4].
struct Chunks {
    std::string json;
    std::optional<std::string> binary;
};

std::uint32_t word_at(const std::string& bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        value |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
    }
    return value;
}

Chunks split_glb(const std::string& bytes, const std::string& source) {
    constexpr std::uint32_t json_chunk = 0x4E4F534A;
    constexpr std::uint32_t binary_chunk = 0x004E4942;
    constexpr std::size_t header = 12;
    constexpr std::size_t chunk_header = 8;
    if (bytes.size() < header + chunk_header || bytes.compare(0, 4, "glTF") != 0) {
        throw SceneError(source, "is not a binary glTF file", "it must begin with \"glTF\"");
    }
    if (word_at(bytes, 8) != bytes.size()) {
        throw SceneError(
            source,
            fmt::format("says that it has {} bytes, but has {}", word_at(bytes, 8), bytes.size()),
            "it may have been cut off; restore its end");
    }
    Chunks chunks;
    for (std::size_t at = header; at + chunk_header <= bytes.size();) {
        const std::size_t size = word_at(bytes, at);
        const std::uint32_t type = word_at(bytes, at + 4);
        at += chunk_header;
        if (size > bytes.size() - at) {
            throw SceneError(source, fmt::format("its chunk at byte {} ends behind the file", at),
                             "it may have been cut off; restore its end");
        }
        if (type == json_chunk && chunks.json.empty()) chunks.json = bytes.substr(at, size);
        if (type == binary_chunk && !chunks.binary) chunks.binary = bytes.substr(at, size);
        at += size;
    }
    return chunks;
}

std::vector<std::string> load_buffers(const JsonView& root, std::optional<std::string>& binary,
                                      const std::filesystem::path& folder) {
    std::vector<std::string> buffers;
    std::set<std::string> uris;
    for (const JsonView& buffer : root.items("buffers")) {
        const auto length = static_cast<std::size_t>(buffer.at("byteLength").integer(1));
        const auto uri = buffer.find("uri");
        if (!uri && (!buffers.empty() || !binary)) {
            buffer.fail("has no \"uri\"",
                        "only the first buffer of a .glb with a BIN chunk may go without");
        }
        if (uri && !uris.insert(uri->text()).second) {
            uri->fail("is the file of an earlier buffer too", "let views share one buffer");
        }
        buffers.push_back(uri ? load_uri(*uri, folder)
                              : std::exchange(binary, std::nullopt).value());
        if (buffers.back().size() < length) {
            buffer.at("byteLength")
                .fail(fmt::format("is {}, but there are {} bytes", length, buffers.back().size()),
                      "the data may have been cut off; restore its end");
        }
        buffers.back().resize(length);
    }
    return buffers;
}

void check_version(const JsonView& root) {
    const JsonView version = root.at("asset").at("version");
    if (version.text().substr(0, 2) != "2.") {
        version.fail("is " + in_quotes(version.text()), "export the scene as glTF 2.0");
    }
    for (const JsonView& extension : root.items("extensionsRequired")) {
        const std::string name = extension.text();
        if (std::find(supported_extensions.begin(), supported_extensions.end(), name) ==
            supported_extensions.end()) {
            extension.fail("the file cannot be read without " + in_quotes(name),
                           "export it without this extension");
        }
    }
}

}  // namespace

std::string load_uri(const JsonView& uri, const std::filesystem::path& folder) {
    std::string text = uri.text();
    if (!tinygltf::IsDataURI(text))
        return read_bytes(file_inside(folder, percent_decoded(text), uri));
    std::vector<unsigned char> bytes;
    std::string mime_type;
    if (!tinygltf::DecodeDataURI(&bytes, mime_type, text, 0, false)) {
        uri.fail("is a data URI that cannot be decoded",
                 "write \"data:application/octet-stream;base64,\" and base64 text");
    }
    return {bytes.begin(), bytes.end()};
}

GltfDocument open_gltf(const std::filesystem::path& path) {
    const std::string source = path.string();
    Chunks chunks{read_bytes(path), std::nullopt};
    if (chunks.json.compare(0, 4, "glTF") == 0 || path.extension() == ".glb") {
        chunks = split_glb(chunks.json, source);
    }
    GltfDocument document{parse_json(chunks.json, source), {}};
    const JsonView root(document.json);
    check_version(root);
    document.buffers = load_buffers(root, chunks.binary, path.parent_path());
    return document;
}

}  // namespace plumbline
