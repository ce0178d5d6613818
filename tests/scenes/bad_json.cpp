// SPDX-License-Identifier: Apache-2.0
// Bad scene files and the one line that each gets.
#include <catch2/catch.hpp>

#include "scenes/errors.h"
#include "scenes/scene_files.h"
#include "tests/scenes/bad_json_cases.h"
#include "tests/scenes/temporary_folder.h"

using namespace plumbline;

namespace {

const std::string good = R"({
    "name": "small",
    "materials": [{"name": "grey", "albedo": 0.7}],
    "meshes": [{"name": "triangle", "positions": [[0, 0, 0], [1, 0, 0], [0, 1, 0]],
                "triangles": [[0, 1, 2]], "material": "grey"}],
    "objects": [
        {"name": "ball", "sphere": {"radius": 1, "material": "grey"}, "scale": 2},
        {"name": "box", "parent": "ball", "rotation": {"axis": [0, 1, 0], "degrees": 30},
         "box": {"lower": [0, 0, 0], "upper": [1, 1, 1], "material": "grey"},
         "animation": {"translation": {"frames": [1, 5], "values": [[0, 0, 0], [1, 0, 0]]}}},
        {"name": "leaf", "quad": {"corner": [0, 0, 0], "edge_u": [1, 0, 0], "edge_v": [0, 1, 0], "material": "grey"}},
        {"name": "shard", "mesh": "triangle"}
    ],
    "lights": [{"name": "lamp", "position": [0, 5, 0], "intensity": [1, 1, 1]}],
    "camera": {"eye": [0, 0, 5], "target": [0, 0, 0], "up": [0, 1, 0], "vertical_fov": 45,
               "width": 64, "height": 32},
    "frames": 10, "frames_per_second": 24,
    "probes": {"origin": [0, 0, 0], "spacing": 0.5, "counts": [2, 3, 4]}
}
)";

/// The good file with `from`, which must stand in it, replaced.
std::string with(const std::string& from, const std::string& to) {
    const std::size_t at = good.find(from);
    REQUIRE(at != std::string::npos);
    return good.substr(0, at) + to + good.substr(at + from.size());
}

/// What is said of a file of this text, its folder left out.
std::string complaint(const std::string& text) {
    const TemporaryFolder folder;
    const std::string path = folder.write("s.json", text);
    try {
        load_scene(path);
    } catch (const SceneError& error) {
        const std::string line = error.what();
        const std::string prefix = folder.path().string() + "/";
        REQUIRE(line.rfind(prefix, 0) == 0);
        return line.substr(prefix.size());
    }
    return "accepted";
}

}  // namespace

TEST_CASE("a bad scene file gets one line: file, place, what is wrong, what would be right",
          "[scenes][bad-input]") {
    REQUIRE(complaint(good) == "accepted");
    for (const BadJson& bad : bad_json_cases) {
        INFO(bad.from << "  ->  " << bad.to);
        const std::string line = complaint(with(bad.from, bad.to));
        CHECK(line == bad.line);
        CHECK(line.find('\n') == std::string::npos);
    }
}

TEST_CASE("a scene file that is cut off anywhere is refused", "[scenes][bad-input]") {
    const std::size_t last_brace = good.rfind('}');
    for (std::size_t size = 0; size <= last_brace; ++size) {
        INFO(size);
        CHECK(complaint(good.substr(0, size)).find("the file ends in the middle") !=
              std::string::npos);
    }
}

TEST_CASE("hostile JSON is refused without trouble", "[scenes][bad-input]") {
    const std::string deep = complaint(std::string(1'000'000, '['));
    CHECK(deep.find("is nested more than 64 deep; a scene needs less") != std::string::npos);
    CHECK(complaint("") ==
          "s.json:1:1: the file ends in the middle of a value; it may have been cut off; restore "
          "its end");
    CHECK(complaint("\xff\xfe{}").find("s.json:1:1: syntax error") == 0);
    CHECK(complaint(with("small", "sm\\u0000\\nall")) == "accepted");
    CHECK(complaint(with("\"name\": \"small\"", "\"\\n\": 1")) ==
          "s.json: unknown key \"\\x0a\"; known are \"$schema\", \"name\", \"description\", "
          "\"units\", \"materials\", \"meshes\", \"objects\", \"lights\", \"environment\", "
          "\"camera\", \"frames\", \"report_frame\" and 3 more");
}
