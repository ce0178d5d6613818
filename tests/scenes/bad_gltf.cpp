// SPDX-License-Identifier: Apache-2.0
// Bad glTF files and the one line that each gets.
#include <catch2/catch.hpp>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "scenes/errors.h"
#include "scenes/scene_files.h"
#include "tests/scenes/temporary_folder.h"

using namespace plumbline;
using nlohmann::json;

namespace {

std::string bytes_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// An exported scene whose JSON and buffer a test may spoil.
struct Exported {
    TemporaryFolder folder;
    json gltf;
    std::string buffer;

    explicit Exported(const std::string& scene) {
        save_scene(load_scene(scene), folder / "s.gltf");
        gltf = json::parse(bytes_of(folder / "s.gltf"));
        buffer = bytes_of(folder / "s.bin");
    }
    std::string complaint(const std::string& name = "s.gltf") const {
        folder.write("s.bin", buffer);
        if (name == "s.gltf") folder.write(name, gltf.dump());
        try {
            load_scene((folder / name).string());
        } catch (const SceneError& error) {
            return std::string(error.what()).substr(folder.path().string().size() + 1);
        }
        return "accepted";
    }
};

std::string glb(const json& gltf, const std::string& buffer) {
    std::string text = gltf.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string binary = buffer;
    binary.resize((binary.size() + 3) / 4 * 4, '\0');
    const auto word = [](std::size_t value) {
        std::string bytes(4, '\0');
        for (std::size_t i = 0; i < 4; ++i) bytes[i] = static_cast<char>(value >> (8 * i));
        return bytes;
    };
    return "glTF" + word(2) + word(28 + text.size() + binary.size()) + word(text.size()) + "JSON" +
           text + word(binary.size()) + std::string("BIN\0", 4) + binary;
}

}  // namespace

TEST_CASE("a .glb is read like the .gltf with its buffer beside it", "[scenes][files]") {
    Exported exported("room-with-door");
    exported.gltf["buffers"][0].erase("uri");
    const std::string whole = glb(exported.gltf, exported.buffer);
    const std::string path = exported.folder.write("s.glb", whole);
    CHECK(load_scene(path) == load_scene("room-with-door"));
    for (const std::size_t size : {0u, 3u, 12u, 19u, 20u, 500u}) {
        exported.folder.write("s.glb", whole.substr(0, size));
        CHECK(exported.complaint("s.glb") != "accepted");
    }
    exported.folder.write("s.glb", whole.substr(0, whole.size() - 1));
    CHECK(exported.complaint("s.glb").find("it may have been cut off") != std::string::npos);
}

TEST_CASE("a bad glTF file gets one line: file, place, what is wrong, what would be right",
          "[scenes][bad-input]") {
    Exported bad("cornell-box");
    REQUIRE(bad.complaint() == "accepted");
    json& gltf = bad.gltf;
    SECTION("a buffer that is cut off") {
        const std::string size = std::to_string(bad.buffer.size());
        bad.buffer.pop_back();
        CHECK(bad.complaint() == "s.gltf: /buffers/0/byteLength: is " + size + ", but there are " +
                                     std::to_string(bad.buffer.size()) +
                                     " bytes; the data may have been cut off; restore its end");
    }
    SECTION("a buffer that leaves the folder") {
        gltf["buffers"][0]["uri"] = "%2e%2e/s.bin";
        CHECK(bad.complaint() ==
              "s.gltf: /buffers/0/uri: \"../s.bin\" is not in the scene's folder; put the file "
              "into that folder or below, and name it relative to it");
    }
    SECTION("a view past the end of its buffer") {
        gltf["bufferViews"][1]["byteOffset"] = bad.buffer.size() - 4;
        CHECK(bad.complaint().find("s.gltf: /bufferViews/1: ends at byte ") == 0);
    }
    SECTION("an accessor past the end of its view") {
        gltf["accessors"][0]["count"] = 5;
        CHECK(bad.complaint() ==
              "s.gltf: /accessors/0/bufferView: 5 elements end at byte 60 of a view of 48; lower "
              "\"count\", or make the view longer");
    }
    SECTION("an accessor that does not exist") {
        gltf["meshes"][0]["primitives"][0]["indices"] = 999;
        CHECK(bad.complaint().find("s.gltf: /meshes/0/primitives/0/indices: asks for accessor 999;"
                                   " there are 0 to ") == 0);
    }
    SECTION("an index past the vertices") {
        bad.buffer[48] = 4;
        CHECK(bad.complaint() ==
              "s.gltf: /meshes/0/primitives/0/indices: index 0 asks for vertex 4; there are 0 to "
              "3");
    }
    SECTION("a vertex that is not a number") {
        const float nan = std::numeric_limits<float>::quiet_NaN();
        std::memcpy(bad.buffer.data(), &nan, sizeof nan);
        CHECK(bad.complaint() ==
              "s.gltf: /meshes/0: positions/0: is not finite; write finite numbers");
    }
    SECTION("a node in a cycle") {
        gltf["nodes"][0]["children"] = {1};
        gltf["nodes"][1]["children"] = {0};
        CHECK(bad.complaint() ==
              "s.gltf: /nodes/0: stands in the hierarchy twice, or is its own ancestor; a node "
              "has one parent");
    }
    SECTION("only nodes in cycles") {
        gltf.erase("scene");
        gltf.erase("scenes");
        for (std::size_t i = 0; i < gltf["nodes"].size(); ++i) {
            gltf["nodes"][i]["children"] = {(i + 1) % gltf["nodes"].size()};
        }
        CHECK(bad.complaint() ==
              "s.gltf: /nodes: every node is the child of another; one must be at the top");
    }
    SECTION("a translation of the wrong type") {
        gltf["nodes"][6]["translation"] = {1, 2, "3"};
        CHECK(bad.complaint() ==
              "s.gltf: /nodes/6/translation/2: is the text \"3\"; write a number");
    }
    SECTION("an albedo above one") {
        gltf["materials"][1]["pbrMetallicRoughness"]["baseColorFactor"] = {0, 1.5, 0, 1};
        CHECK(bad.complaint().find("s.gltf: /materials/1: albedo: is 1.5, outside [0, 1]") == 0);
    }
    SECTION("an extension that it cannot be read without") {
        gltf["extensionsRequired"] = {"KHR_draco_mesh_compression"};
        CHECK(bad.complaint() ==
              "s.gltf: /extensionsRequired/0: the file cannot be read without "
              "\"KHR_draco_mesh_compression\"; export it without this extension");
    }
    SECTION("another version") {
        gltf["asset"]["version"] = "1.0";
        CHECK(bad.complaint() ==
              "s.gltf: /asset/version: is \"1.0\"; export the scene as glTF 2.0");
    }
    SECTION("keyframes that fall") {
        const std::size_t input = gltf["animations"][0]["samplers"][0]["input"];
        const std::size_t view = gltf["accessors"][input]["bufferView"];
        const std::size_t offset = gltf["bufferViews"][view]["byteOffset"];
        const float late = 100.f;
        std::memcpy(&bad.buffer[offset], &late, sizeof late);
        CHECK(bad.complaint() ==
              "s.gltf: /animations/0/samplers/0/input: keyframe 1 is not later than the one "
              "before; keyframes must rise");
    }
    SECTION("a file that asks for far more numbers than it holds") {
        gltf["accessors"][0] = {{"componentType", 5126}, {"type", "VEC3"}, {"count", 2000000000}};
        CHECK(bad.complaint().find("the file asks for far more numbers than it holds") !=
              std::string::npos);
    }
}
