// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <limits>

#include "scenes/errors.h"
#include "scenes/image.h"
#include "scenes/scene_files.h"
#include "scenes/world.h"
#include "tests/scenes/temporary_folder.h"

using namespace plumbline;

namespace {

std::string scene_with(const std::string& environment) {
    return R"({"name": "s", "camera": {"eye": [0, 0, 5], "target": [0, 0, 0]}, "environment": )" +
           environment + "}";
}

void write_sky(const TemporaryFolder& folder, float value = 2.f) {
    Image sky(4, 2);
    for (const auto& channel : sky.layer("")) std::fill(channel.begin(), channel.end(), 1.f);
    sky.channel("G")[0] = value;
    write_exr(folder / "sky.exr", sky);
}

std::string complaint(const TemporaryFolder& folder, const std::string& environment) {
    const std::string path = folder.write("s.json", scene_with(environment));
    try {
        load_scene(path);
    } catch (const InputError& error) {
        return std::string(error.what()).substr(folder.path().string().size() + 1);
    }
    return "accepted";
}

}  // namespace

TEST_CASE("a picture of the environment is read, turned and written again", "[scenes][files]") {
    const TemporaryFolder folder;
    write_sky(folder);
    const std::string path = folder.write(
        "s.json", scene_with(R"({"image": "sky.exr", "radiance": [1, 3, 1], "rotation": 90})"));
    const Scene scene = load_scene(path);
    REQUIRE(scene.environment_image);
    const World world = world_at(scene, 0);
    // The first pixel lies behind (+z), up, left of the middle; turned by 90 degrees towards +x.
    const glm::vec3 unturned = Panorama::direction({.125, .25});
    const glm::vec3 turned(unturned.z, unturned.y, -unturned.x);
    CHECK(environment_radiance(world, turned) == Spectrum(1.f, 6.f, 1.f));
    CHECK(environment_radiance(world, -turned) == Spectrum(1.f, 3.f, 1.f));
    for (const char* name : {"again.json", "again.gltf"}) {
        std::filesystem::create_directories(folder / "elsewhere");
        const auto written = folder / "elsewhere" / name;
        save_scene(scene, written);
        CHECK(load_scene(written.string()).environment_image == scene.environment_image);
        CHECK(load_scene(written.string()).environment == scene.environment);
    }
}

TEST_CASE("a bad picture of the environment gets its line", "[scenes][bad-input]") {
    const TemporaryFolder folder;
    write_sky(folder);
    CHECK(complaint(folder, R"({"image": "sky.exr"})") == "accepted");
    CHECK(complaint(folder, R"({"image": "missing.exr"})") ==
          "missing.exr: no such file; name an image file");
    CHECK(complaint(folder, R"({"image": "../sky.exr"})") ==
          "s.json: /environment/image: \"../sky.exr\" is not in the scene's folder; put the file "
          "into that folder or below, and name it relative to it");
    CHECK(complaint(folder, R"({"radiance": 1})") ==
          "s.json: /environment: has no \"image\"; add it");
    CHECK(complaint(folder, R"({"image": "sky.exr", "radiance": -1})") ==
          "s.json: /environment: is negative (-1); light has a power of 0 or more");
    write_sky(folder, std::numeric_limits<float>::quiet_NaN());
    CHECK(complaint(folder, R"({"image": "sky.exr"})") ==
          "sky.exr: its pixel (0, 0) is negative or not finite; light is 0 or more in every pixel");
}
