// SPDX-License-Identifier: Apache-2.0
// The subcommands of this folder, and what bad scenes do to the program, through the binary.
#include <sys/wait.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <iterator>
#include <nlohmann/json.hpp>

#include "scenes/scene_files.h"
#include "tests/scenes/temporary_folder.h"

using namespace plumbline;

namespace {

struct Outcome {
    int code;
    std::string out;
    std::string err;
};

std::string text_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Runs `plumbline ARGS` in the folder.
Outcome run(const TemporaryFolder& folder, const std::string& args) {
    const std::string command = "cd '" + folder.path().string() + "' && '" PLUMBLINE_BINARY "' " +
                                args + " >stdout.txt 2>stderr.txt";
    const int status = std::system(command.c_str());
    REQUIRE(WIFEXITED(status));
    return {WEXITSTATUS(status), text_of(folder / "stdout.txt"), text_of(folder / "stderr.txt")};
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    REQUIRE(text.find(from) != std::string::npos);
    return text.replace(text.find(from), from.size(), to);
}

const std::string room =
    text_of(std::filesystem::path(PLUMBLINE_SOURCE_DIR) / "scenes/library/room-with-door.json");

}  // namespace

TEST_CASE("a bad scene costs one line and exit code 2, and leaves no output",
          "[scenes][commands]") {
    const std::string command =
        GENERATE("inspect s.json --json", "export s.json -o out.gltf", "export s.json -o out.json",
                 "render s.json --size 8x8 --spp 1 --quiet -o out.exr",
                 "ddgi s.json --size 8x8 --updates 1 --quiet -o out.exr");
    const TemporaryFolder folder;
    const auto check_refused = [&](const std::string& expected) {
        const Outcome outcome = run(folder, command);
        INFO(command << ": " << outcome.err);
        CHECK(outcome.code == 2);
        CHECK(outcome.err.find(expected) != std::string::npos);
        CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
        CHECK(outcome.out.empty());
        for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
            const std::string name = entry.path().filename().string();
            CHECK((name == "s.json" || name == "stdout.txt" || name == "stderr.txt"));
        }
    };
    check_refused("s.json: No such file or directory; check its name");
    folder.write("s.json", room.substr(0, room.find("\"name\": \"door\"") + 40));
    check_refused("the file ends in the middle of a value; it may have been cut off");
    folder.write("s.json", replaced(room, "\"translation\"", "\"translaton\""));
    check_refused("s.json: /objects/2: unknown key \"translaton\"; did you mean \"translation\"?");
    folder.write("s.json", replaced(room, "\"albedo\": 0.7", "\"albedo\": 1.5"));
    check_refused("s.json: /materials/0/albedo: is 1.5, outside [0, 1]; ");
}

TEST_CASE("a name that is no scene is answered with the nearest one", "[scenes][commands]") {
    const TemporaryFolder folder;
    const Outcome outcome = run(folder, "inspect cornel-box");
    CHECK(outcome.code == 2);
    CHECK(outcome.err.find("did you mean \"cornell-box\"?") != std::string::npos);
}

TEST_CASE("built-in scenes load from any folder, and scenes --json lists them",
          "[scenes][commands]") {
    const TemporaryFolder folder;
    const Outcome outcome = run(folder, "scenes --json");
    CHECK(outcome.code == 0);
    CHECK(outcome.err.empty());
    std::vector<std::string> names;
    for (const auto& scene : nlohmann::json::parse(outcome.out)) names.push_back(scene["name"]);
    CHECK(names == builtin_scene_names());
}

TEST_CASE("inspect --json tells contents, effects and what is skipped", "[scenes][commands]") {
    const TemporaryFolder folder;
    const auto json = nlohmann::json::parse(run(folder, "inspect furnace --json").out);
    CHECK(json["triangles"] == 12);
    CHECK(json["objects"].size() == 6);
    const auto lists = [&](const char* key, const char* effect) {
        for (const auto& entry : json[key]) {
            if (entry["effect"] == effect) return !entry["why"].get<std::string>().empty();
        }
        return false;
    };
    CHECK(lists("effects", "emission"));
    CHECK(lists("skipped", "point lights"));
    CHECK(lists("skipped", "environment"));
    CHECK(lists("skipped", "animation"));
    CHECK_FALSE(lists("effects", "point lights"));
}

TEST_CASE("export writes a scene that inspect finds the same", "[scenes][commands]") {
    const TemporaryFolder folder;
    REQUIRE(run(folder, "export two-rooms -o new/rooms.gltf").code == 0);
    CHECK(run(folder, "inspect new/rooms.gltf --frame 100 --json").out ==
          run(folder, "inspect two-rooms --frame 100 --json").out);
    CHECK(run(folder, "export two-rooms -o rooms.obj").code == 2);
}

TEST_CASE("inspect warns of triangles without area and of coordinates too large",
          "[scenes][commands]") {
    const TemporaryFolder folder;
    folder.write("s.json", R"({"name": "far", "materials": [{"name": "m", "albedo": 0.5}],
        "objects": [{"name": "sliver", "translation": [1e7, 0, 0], "mesh": {
            "positions": [[0, 0, 0], [1, 0, 0], [2, 0, 0], [0, 1, 0]],
            "triangles": [[0, 1, 2], [0, 1, 3]], "material": "m"}}],
        "camera": {"eye": [0, 0, 5], "target": [0, 0, 0]}})");
    const auto json = nlohmann::json::parse(run(folder, "inspect s.json --json").out);
    REQUIRE(json["warnings"].size() == 3);
    CHECK(json["warnings"][0] == "\"sliver\" has 1 triangle without area: nothing can hit them");
    CHECK(json["warnings"][1] ==
          "coordinates reach 1e+07, where a float's steps are 1: that is 0.5 of the size of "
          "\"sliver\" (2); move the scene to the origin");
}

TEST_CASE("inspect warns of what is too small for rays to meet, and gives it a grid all the same",
          "[scenes][commands]") {
    const TemporaryFolder folder;
    // A step of a float high, so that it has a size, and none that probes could be spread over.
    folder.write("s.json", R"({"name": "dust", "materials": [{"name": "m", "albedo": 0.5}],
        "objects": [{"name": "mote", "mesh": {
            "positions": [[0, 0, 1], [0, 1e-45, 1], [1e-10, 0, 1]],
            "triangles": [[0, 1, 2]], "material": "m"}}],
        "camera": {"eye": [0, 0, 5], "target": [0, 0, 0]}})");
    const auto json = nlohmann::json::parse(run(folder, "inspect s.json --json").out);
    REQUIRE(json["warnings"].size() >= 2);
    CHECK(json["warnings"][0] ==
          "\"mote\" has 1 triangle of an area below 5e-19: all hits are put to a corner; "
          "scale the scene up");
    CHECK(json["warnings"][1] ==
          "\"mote\" is 1e-10 across: rays may miss what is below 1e-08; scale the scene up");
    CHECK(json["probes"]["spacing"] == 1.);
    CHECK(json["probes"]["counts"] == nlohmann::json({2, 2, 2}));
}
