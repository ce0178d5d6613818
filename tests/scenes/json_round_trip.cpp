// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>

#include "scenes/scene_files.h"

using namespace plumbline;
namespace fs = std::filesystem;

TEST_CASE("a built-in scene written as JSON reads back as the same scene", "[scenes][json]") {
    const auto names = builtin_scene_names();
    CHECK(names == std::vector<std::string>{"cornell-box", "furnace", "integrating-sphere",
                                            "room-with-door", "two-rooms"});
    const fs::path path =
        fs::temp_directory_path() / ("plumbline-round-trip-" + std::to_string(getpid()) + ".json");
    for (const std::string& name : names) {
        INFO(name);
        const Scene scene = load_scene(name);
        save_scene(scene, path);
        CHECK(load_scene(path.string()) == scene);
    }
    fs::remove(path);
}
