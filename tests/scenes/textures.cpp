// SPDX-License-Identifier: Apache-2.0
// Albedo from pictures: look-up, decoding, files.
#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "scenes/errors.h"
#include "scenes/image.h"
#include "scenes/ray_tracer.h"
#include "scenes/scene_files.h"
#include "scenes/texture.h"
#include "tests/scenes/temporary_folder.h"

using namespace plumbline;

namespace {

/// 2 x 2 pixels: red, green, blue, and a grey of sRGB 188.
const std::array<unsigned char, 12> pixels{255, 0, 0, 0, 255, 0, 0, 0, 255, 188, 188, 188};

Texture small(Wrap wrap) {
    auto picture = std::make_shared<Picture>();
    picture->width = picture->height = 2;
    picture->albedo = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, Spectrum(.5f)};
    return {picture, wrap, wrap};
}

/// A square in z = 0 that shows the whole picture, upright, to an eye at +z.
std::string scene_with(const std::string& material, const std::string& texcoords) {
    return R"({"name": "s", "materials": [{"name": "m", )" + material + R"(}],
        "objects": [{"name": "square", "mesh": {
            "positions": [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]],
            "triangles": [[0, 1, 2], [0, 2, 3]], "material": "m")" +
           texcoords + R"(}}],
        "camera": {"eye": [0, 0, 5], "target": [0, 0, 0]}})";
}
const std::string upright = R"(, "texcoords": [[0, 1], [1, 1], [1, 0], [0, 0]])";

std::string complaint(const TemporaryFolder& folder, const std::string& text) {
    const std::string path = folder.write("s.json", text);
    try {
        load_scene(path);
    } catch (const InputError& error) {
        return std::string(error.what()).substr(folder.path().string().size() + 1);
    }
    return "accepted";
}

/// Albedo seen from the front at (x, y) of the square.
Spectrum seen(const Scene& scene, float x, float y) {
    const World world = world_at(scene, 0);
    const RayTracer tracer(world);
    const auto hit = tracer.intersect({{x, y, 5.f}, {0.f, 0.f, -1.f}}, BackFaces::Cull);
    REQUIRE(hit);
    return hit->albedo;
}

}  // namespace

TEST_CASE("a texture shows its pixels at their middles and blends between them", "[scenes]") {
    const Texture texture = small(Wrap::Repeat);
    CHECK(texture.at({.25f, .25f}) == Spectrum(1, 0, 0));
    CHECK(texture.at({.75f, .25f}) == Spectrum(0, 1, 0));
    CHECK(texture.at({.25f, .75f}) == Spectrum(0, 0, 1));
    CHECK(texture.at({.75f, .75f}) == Spectrum(.5f));
    CHECK(texture.at({.5f, .25f}) == Spectrum(.5f, .5f, 0));
    CHECK(texture.at({.5f, .5f}) == Spectrum(.375f, .375f, .375f));
}

TEST_CASE("beside a texture lies what its wrap says", "[scenes]") {
    for (const float turn : {-2.f, -1.f, 1.f, 6.f}) {
        CHECK(small(Wrap::Repeat).at({.25f + turn, .25f}) == Spectrum(1, 0, 0));
        CHECK(small(Wrap::Repeat).at({.25f, .75f + turn}) == Spectrum(0, 0, 1));
    }
    CHECK(small(Wrap::Repeat).at({0.f, .25f}) == Spectrum(.5f, .5f, 0));
    CHECK(small(Wrap::Mirror).at({0.f, .25f}) == Spectrum(1, 0, 0));
    CHECK(small(Wrap::Mirror).at({-.75f, .25f}) == Spectrum(0, 1, 0));
    CHECK(small(Wrap::Mirror).at({1.25f, .25f}) == Spectrum(0, 1, 0));
    CHECK(small(Wrap::Clamp).at({-7.f, .25f}) == Spectrum(1, 0, 0));
    CHECK(small(Wrap::Clamp).at({7.f, .25f}) == Spectrum(0, 1, 0));
}

TEST_CASE("a mesh wears its texture and takes it along when it is written", "[scenes][files]") {
    const TemporaryFolder folder;
    write_png(folder / "p.png", 2, 2, pixels);
    const std::string path = folder.write(
        "s.json",
        scene_with(R"("albedo": 0.5, "texture": {"image": "p.png", "wrap": "clamp"})", upright));
    const Scene scene = load_scene(path);
    const auto check = [](const Scene& shown) {
        CHECK(seen(shown, .25f, .75f).r == Approx(.5f));
        CHECK(seen(shown, .25f, .75f).g == Approx(0.f).margin(1e-6));
        CHECK(seen(shown, .75f, .75f).g == Approx(.5f));
        CHECK(seen(shown, .25f, .25f).b == Approx(.5f));
        // sRGB 188 of 255 is linear ((188/255 + .055) / 1.055)^2.4 [IEC 61966-2-1].
        CHECK(seen(shown, .75f, .25f).r ==
              Approx(.5 * std::pow((188. / 255. + .055) / 1.055, 2.4)).epsilon(1e-4));
    };
    check(scene);
    for (const char* name : {"again.json", "again.gltf"}) {
        const auto elsewhere = folder / "elsewhere";
        std::filesystem::create_directories(elsewhere);
        save_scene(scene, elsewhere / name);
        const Scene again = load_scene((elsewhere / name).string());
        CHECK(again.materials == scene.materials);
        CHECK(again.meshes == scene.meshes);
        check(again);
    }
}

TEST_CASE("a picture within a glTF file is read", "[scenes][files]") {
    const TemporaryFolder folder;
    write_png(folder / "p.png", 2, 2, pixels);
    folder.write("s.json", scene_with(R"("texture": "p.png")", upright));
    const Scene scene = load_scene((folder / "s.json").string());
    save_scene(scene, folder / "s.gltf");
    const auto bytes_of = [&](const char* name) {
        std::ifstream file(folder / name, std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(file), {});
    };
    // The same picture behind the buffer's other bytes.
    nlohmann::json gltf = nlohmann::json::parse(bytes_of("s.gltf"));
    const std::string buffer = bytes_of("s.bin"), picture = bytes_of("p.png");
    folder.write("s.bin", buffer + picture);
    gltf["buffers"][0]["byteLength"] = buffer.size() + picture.size();
    gltf["images"][0] = {{"bufferView", gltf["bufferViews"].size()}, {"mimeType", "image/png"}};
    gltf["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", picture.size()}});
    folder.write("s.gltf", gltf.dump());
    CHECK(load_scene((folder / "s.gltf").string()).materials == scene.materials);
}

TEST_CASE("a picture is never written over another file", "[scenes][files]") {
    const TemporaryFolder folder;
    write_png(folder / "p.png", 2, 2, pixels);
    folder.write("s.json", scene_with(R"("texture": "p.png")", upright));
    const Scene scene = load_scene((folder / "s.json").string());
    std::filesystem::create_directories(folder / "other");
    folder.write("other/p.png", "something dear");
    CHECK_THROWS_WITH(save_scene(scene, folder / "other/s.json"),
                      Catch::Contains("another file of this name stands where a picture belongs"));
}

TEST_CASE("a bad texture gets its line", "[scenes][bad-input]") {
    const TemporaryFolder folder;
    write_png(folder / "p.png", 2, 2, pixels);
    folder.write("t.png", "no picture");
    CHECK(complaint(folder, scene_with(R"("texture": "p.png")", upright)) == "accepted");
    CHECK(complaint(folder, scene_with(R"("texture": "p.png")", "")) ==
          "s.json: /objects/0/mesh/texcoords: are missing, but material \"m\" has a texture; give "
          "one a position");
    CHECK(complaint(folder, scene_with(R"("texture": "../p.png")", upright)) ==
          "s.json: /materials/0/texture: \"../p.png\" is not in the scene's folder; put the file "
          "into that folder or below, and name it relative to it");
    CHECK(complaint(folder, scene_with(R"("texture": "t.png")", upright)).rfind("t.png: ", 0) == 0);
    CHECK(
        complaint(folder,
                  scene_with(R"("texture": {"image": "p.png", "wrap": "repaet"})", upright)) ==
        "s.json: /materials/0/texture/wrap: there is no wrap \"repaet\"; did you mean \"repeat\"?");
    CHECK(
        complaint(folder, scene_with(R"("texture": "p.png")", R"(, "texcoords": [[0, 1]])")) ==
        "s.json: /objects/0/mesh/texcoords: has 1 entries for 4 positions; give one a position, or "
        "none");
    Image bright(1, 1);
    for (const auto& channel : bright.layer("")) channel[0] = 1.5f;
    write_exr(folder / "b.exr", bright);
    CHECK(
        complaint(folder, scene_with(R"("texture": "b.exr")", upright)) ==
        "b.exr: its pixel (0, 0) is outside [0, 1]; albedo is a share of the light that falls on a "
        "surface");
}
