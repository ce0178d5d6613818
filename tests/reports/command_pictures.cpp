// SPDX-License-Identifier: Apache-2.0
#include <sys/wait.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "scenes/scene_files.h"
#include "tests/reports/page_parts.h"
#include "tests/scenes/temporary_folder.h"

using namespace plumbline;
namespace fs = std::filesystem;

namespace {

int pictures(const std::string& arguments) {
    const std::string command = std::string(PLUMBLINE_BINARY) + " pictures " + arguments;
    return WEXITSTATUS(std::system((command + " >/dev/null 2>&1").c_str()));
}

std::string text_of(const fs::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// The data URI of every picture on a page, in its order.
std::vector<std::string> uris(const std::string& html) {
    const std::string start = "data:image/png;base64,";
    std::vector<std::string> list;
    for (auto at = html.find(start); at != std::string::npos; at = html.find(start, at + 1))
        list.push_back(html.substr(at, html.find('"', at) - at));
    return list;
}

/// The scene on a grid that is lit in no time.
fs::path coarse_scene(const fs::path& folder, const std::string& name) {
    Scene scene = load_scene(name);
    scene.probes = ProbeGrid{{-200, 0, -200}, 80, {6, 6, 6}};
    scene.report_frame = 0;
    const fs::path file = folder / (name + ".json");
    save_scene(scene, file);
    return file;
}

}  // namespace

TEST_CASE("one command shows the published figures with hard shadows and with soft ones",
          "[reports][pictures]") {
    const TemporaryFolder folder;
    const std::string scenes = coarse_scene(folder.path(), "cornell-box").string() + " " +
                               coarse_scene(folder.path(), "room-with-door").string();
    const fs::path out = folder.path() / "out";
    REQUIRE(pictures(scenes + " --size 32x18 --shadow-rays 8 -o " + out.string()) == 0);
    const std::string html = text_of(out / "index.html");
    // Once as the caption, once for those who cannot see the picture.
    for (int figure = 1; figure <= 9; ++figure)
        CHECK(reports::count(html, "Figure 5." + std::to_string(figure) + ": ") == 2);
    const std::vector<std::string> shown = uris(html);
    REQUIRE(shown.size() == 12);
    for (const std::size_t scene : {0, 6}) {
        CHECK(shown[scene] != shown[scene + 1]);
        CHECK(shown[scene + 1] != shown[scene + 2]);
    }
    CHECK(shown[0] != shown[3]);  // softly shadowed
}

TEST_CASE("a light without radius throws the same shadows with many rays as with one",
          "[reports][pictures]") {
    const TemporaryFolder folder;
    const fs::path out = folder.path() / "out";
    const std::string scene = coarse_scene(folder.path(), "cornell-box").string();
    REQUIRE(pictures(scene + " --size 32x18 --shadow-rays 4 --light-radius 0 -o " + out.string()) ==
            0);
    const std::vector<std::string> shown = uris(text_of(out / "index.html"));
    REQUIRE(shown.size() == 6);
    for (std::size_t i = 0; i < 3; ++i) CHECK(shown[i] == shown[i + 3]);
}

TEST_CASE("pictures refuses what it cannot show before it starts", "[reports][pictures]") {
    const TemporaryFolder folder;
    const std::string out = (folder.path() / "out").string();
    CHECK(pictures("cornell-box --shadow-rays 0 -o " + out) == 2);
    CHECK(pictures("cornell-box --light-radius -1 -o " + out) == 2);
    CHECK(pictures("no-such-scene -o " + out) == 2);
    CHECK_FALSE(fs::exists(out));
}
