// SPDX-License-Identifier: Apache-2.0
// Writes what fuzzing starts from, FOLDER/TARGET/NUMBER: the library's scenes in JSON and as .glb,
// the hand-made bad inputs, and small pictures of every kind that is read.
#include <OpenImageIO/imageio.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "scenes/input_files.h"
#include "scenes/scene_files.h"
#include "scenes/whole_file.h"
#include "tests/bad_input/golden.h"
#include "tests/scenes/temporary_folder.h"

using namespace plumbline;

namespace {

/// Writes the files of all targets below a folder.
class Seeds {
 public:
    explicit Seeds(std::filesystem::path folder) : folder_(std::move(folder)) {}
    void add(const std::string& target, const std::string& bytes) {
        write_text(folder_ / target / std::to_string(count_++), bytes);
    }

 private:
    std::filesystem::path folder_;
    int count_ = 0;
};

std::string word(std::size_t value) {
    std::string bytes;
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xff);
    return bytes;
}

/// One file in place of two [glTF 2.0, section 4.4]: a target gets no more.
std::string glb(const std::string& gltf, const std::string& buffer) {
    auto json = nlohmann::json::parse(gltf);
    json["buffers"][0].erase("uri");
    const std::string text = json.dump();
    return "glTF" + word(2) + word(12 + 8 + text.size() + 8 + buffer.size()) + word(text.size()) +
           "JSON" + text + word(buffer.size()) + std::string("BIN\0", 4) + buffer;
}

void add_library(Seeds& seeds) {
    const TemporaryFolder folder;
    for (const std::string& name : builtin_scene_names()) {
        const Scene scene = load_scene(name);
        save_scene(scene, folder / "s.json");
        save_scene(scene, folder / "s.gltf");
        seeds.add("scene_json", read_bytes(folder / "s.json"));
        seeds.add("gltf", glb(read_bytes(folder / "s.gltf"), read_bytes(folder / "s.bin")));
    }
}

void add_bad_inputs(Seeds& seeds) {
    for (const auto& bad : bad_inputs()) {
        const std::string group = bad.at("group");
        for (const auto& [name, bytes] : bad_files(bad)) {
            const std::string ending = std::filesystem::path(name).extension();
            if (ending == ".json") seeds.add("scene_json", bytes);
            if (ending == ".gltf" || ending == ".glb") seeds.add("gltf", bytes);
            if (ending == ".obj") seeds.add("obj", bytes);
            if (group == "image") seeds.add("image", bytes);
        }
        if (group != "command line") continue;
        std::string words;
        for (const std::string argument : bad.at("arguments")) words += argument + '\0';
        seeds.add("command_line", words);
    }
    const std::string coloured_square =
        "mtllib m.mtl\nusemtl a b\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 1\nv 0 1 0 1 1 1\n"
        "vt 0 0\nvn 0 0 1\ns off\nf 1/1/1 2/1/1 3/1/1 -1\n";
    seeds.add("obj", coloured_square + '\0' +
                         "newmtl a b\nKd .5 .5 .5\nKe 0 0 1\nd .5\nillum 2\nmap_Kd p.png\n# end\n");
}

/// A small picture of a format, as OpenImageIO's name of it, type of value and other settings.
struct Kind {
    const char* ending;
    OIIO::TypeDesc type;
    int channels = 3;
    const char* compression = "";
    int tile = 0;
};

std::string picture(const Kind& kind, const TemporaryFolder& folder) {
    constexpr int width = 9;
    constexpr int height = 5;
    OIIO::ImageSpec spec(width, height, kind.channels, kind.type);
    if (*kind.compression != '\0') spec.attribute("compression", kind.compression);
    spec.tile_width = spec.tile_height = kind.tile;
    std::vector<float> values(std::size_t(width * height * kind.channels));
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = float(i % 7) / 7.f;
    const std::string name = (folder / (std::string("p.") + kind.ending)).string();
    const auto file = OIIO::ImageOutput::create(name);
    if (!file || !file->open(name, spec) ||
        !file->write_image(OIIO::TypeDesc::FLOAT, values.data()) || !file->close()) {
        throw std::runtime_error(name + ": " + (file ? file->geterror() : OIIO::geterror()));
    }
    return read_bytes(name);
}

void add_pictures(Seeds& seeds) {
    using OIIO::TypeDesc;
    const TemporaryFolder folder;
    std::vector<Kind> kinds{{"exr", TypeDesc::FLOAT, 1},
                            {"exr", TypeDesc::UINT32, 1},
                            {"exr", TypeDesc::HALF, 4},
                            {"exr", TypeDesc::HALF, 3, "zip", 8},
                            {"png", TypeDesc::UINT8, 1},
                            {"png", TypeDesc::UINT8, 4},
                            {"png", TypeDesc::UINT16, 3},
                            {"jpg", TypeDesc::UINT8, 3},
                            {"hdr", TypeDesc::FLOAT, 3},
                            {"ppm", TypeDesc::UINT8, 3},
                            {"tif", TypeDesc::FLOAT, 3},
                            {"tif", TypeDesc::UINT8, 3, "lzw"},
                            {"tif", TypeDesc::UINT16, 3, "zip", 16},
                            {"tga", TypeDesc::UINT8, 3},
                            {"bmp", TypeDesc::UINT8, 3},
                            {"webp", TypeDesc::UINT8, 3}};
    for (const char* compression :
         {"none", "rle", "zip", "zips", "piz", "pxr24", "b44", "b44a", "dwaa", "dwab"}) {
        kinds.push_back({"exr", TypeDesc::HALF, 3, compression});
    }
    for (const Kind& kind : kinds) seeds.add("image", picture(kind, folder));
    seeds.add("image", "PF\n2 1\n-1.0\n" + std::string(2 * 3 * sizeof(float), '\0'));
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: %s FOLDER\n", argv[0]);
        return 2;
    }
    Seeds seeds(argv[1]);
    add_library(seeds);
    add_bad_inputs(seeds);
    add_pictures(seeds);
}
