// SPDX-License-Identifier: Apache-2.0
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "scenes/scene_files.h"

using namespace plumbline;
namespace fs = std::filesystem;

namespace {

struct Folder {
    fs::path path = fs::temp_directory_path() / ("plumbline-report-" + std::to_string(::getpid()));
    Folder() { fs::create_directories(path); }
    ~Folder() {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
};

int exit_of(const std::string& arguments) {
    const std::string command =
        std::string(PLUMBLINE_BINARY) + " report " + arguments + " >/dev/null 2>&1";
    return WEXITSTATUS(std::system(command.c_str()));
}

}  // namespace

TEST_CASE("report measures a scene with every model and writes a page and its figures",
          "[reports][command]") {
    const Folder folder;
    const fs::path out = folder.path / "out";
    Scene coarse = load_scene("cornell-box");
    coarse.name = "coarse box";
    coarse.probes = ProbeGrid{{-200, 0, -200}, 80, {6, 6, 6}};
    coarse.report_frame = 201;
    const fs::path file = folder.path / "coarse box.json";
    save_scene(coarse, file);
    REQUIRE(exit_of("'" + file.string() + "' --quick --size 32x18 -o " + out.string()) == 0);
    CHECK(fs::file_size(out / "index.html") > 200'000);
    const nlohmann::json results = nlohmann::json::parse(std::ifstream(out / "results.json"));
    const nlohmann::json& scene = results["scenes"][0];
    CHECK(scene["scene"] == "coarse box");
    CHECK(scene["frame"] == 201);
    CHECK(scene["hash"].get<std::string>().size() == 40);
    CHECK(scene["width"] == 32);
    REQUIRE(scene["models"].size() >= 3);
    const auto rmse_of = [&](const std::string& id) {
        for (const nlohmann::json& model : scene["models"])
            if (model["id"] == id)
                return model["errors"]["indirect"]["metrics"]["rmse"].get<double>();
        FAIL("no model " << id);
        return 0.;
    };
    CHECK(rmse_of("conserving") < rmse_of("thesis"));
    CHECK(rmse_of("thesis-fitted") > 0);
    for (const nlohmann::json& picture : scene["path_tracer"])
        CHECK(picture["errors"]["indirect"]["noise"]["method"] == "independent halves");
    CHECK(scene["animation"]["models"].size() == scene["models"].size());
    CHECK(!scene["frontier"]["points"].empty());
    CHECK(scene["audit"].size() + 1 == scene["models"].size());  // all but the fitted one
    CHECK(results["transfer"].size() == 3 * 5);  // three scenes; two of them at frame 0 too
}

TEST_CASE("report and frontier do without the thesis's model where its probes have no neighbours",
          "[reports][command]") {
    const Folder folder;
    const fs::path out = folder.path / "out";
    Scene room = load_scene("cornell-box");
    room.probes = ProbeGrid{{-200, 0, -200}, 400, {2, 2, 2}};
    const fs::path file = folder.path / "room.json";
    save_scene(room, file);
    REQUIRE(exit_of(file.string() + " --quick --size 16x9 -o " + out.string()) == 0);
    const nlohmann::json results = nlohmann::json::parse(std::ifstream(out / "results.json"));
    const nlohmann::json& scene = results["scenes"][0];
    CHECK(scene["left_out"] ==
          nlohmann::json{"model thesis: a grid of 2 x 2 x 2 probes has no neighbours to read"});
    CHECK(scene["fit"].is_null());
    std::set<std::string> models, methods;
    for (const nlohmann::json& model : scene["models"]) models.insert(model["id"]);
    CHECK(models == std::set<std::string>{"conserving", "irradiance"});
    for (const nlohmann::json& point : scene["frontier"]["points"]) methods.insert(point["method"]);
    CHECK(methods ==
          std::set<std::string>{"path tracer", "irradiance", "conserving", "conserving, octants"});
    std::ifstream page(out / "index.html");
    const std::string html{std::istreambuf_iterator<char>(page), {}};
    CHECK(html.find("Without thesis at the scene") != std::string::npos);
}

TEST_CASE("report refuses what it cannot use, and leaves nothing behind", "[reports][command]") {
    const Folder folder;
    const fs::path out = folder.path / "out";
    CHECK(exit_of("no-such-scene -o " + out.string()) == 2);
    CHECK(exit_of("furnace") == 2);
    CHECK(exit_of("furnace --frame 99999 -o " + out.string()) == 2);
    CHECK(!fs::exists(out));
    std::ofstream(folder.path / "file") << "not a folder";
    CHECK(exit_of("furnace --quick --size 8x8 -o " + (folder.path / "file").string()) == 2);
}
