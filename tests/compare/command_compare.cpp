// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "compare/thresholds.h"
#include "scenes/errors.h"
#include "tests/compare/test_images.h"

using namespace plumbline;
using namespace plumbline::compare;

namespace {

/// A folder that is gone when the test ends.
struct Folder {
    std::filesystem::path path;
    Folder() {
        std::string name = (std::filesystem::temp_directory_path() / "plumbline-XXXXXX").string();
        path = mkdtemp(name.data());
    }
    ~Folder() { std::filesystem::remove_all(path); }
};

std::string text_of(const std::filesystem::path& path) {
    std::stringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

struct Ran {
    int exit_code;
    std::string out, err;
};

Ran run(const Folder& folder, const std::string& arguments) {
    const std::string out = (folder.path / "out").string(), err = (folder.path / "err").string();
    const int status =
        std::system((PLUMBLINE_BINARY " compare " + arguments + " >" + out + " 2>" + err).c_str());
    return {WEXITSTATUS(status), text_of(out), text_of(err)};
}

/// A folder with r.exr and t.exr, 0.1 apart, and a smaller s.exr.
struct Files : Folder {
    Files() {
        const auto flat = [](float value) {
            return [value](int x, int, int) { return value + 0.01f * float(x); };
        };
        write_exr(path / "r.exr", image_of(16, 12, flat(0.5f)));
        write_exr(path / "t.exr", image_of(16, 12, flat(0.6f)));
        write_exr(path / "s.exr", image_of(12, 12, flat(0.6f)));
        both = (path / "r.exr").string() + " " + (path / "t.exr").string();
    }
    std::string both;
};

}  // namespace

TEST_CASE("compare --json prints the keys that scripts rely on", "[compare]") {
    const Files files;
    const Ran ran = run(files, files.both + " --json");
    REQUIRE(ran.exit_code == 0);
    const auto json = nlohmann::json::parse(ran.out);
    for (const char* name : {"bias", "mae", "rmse", "relmse", "smape", "psnr_db", "ssim", "flip"})
        CHECK(json.at("metrics").at(name).is_number());
    CHECK(json.at("metrics").at("bias").get<double>() == Approx(0.1).epsilon(1e-5));
    CHECK(json.at("noise").is_null());
    CHECK(json.at("non_finite") == 0);
    CHECK(json.at("pixels") == 16 * 12);
    CHECK(ran.err.empty());
}

TEST_CASE("compare --fail-above exits with 1 and says which and by how much", "[compare]") {
    const Files files;
    const Ran ran = run(files, files.both + " --fail-above rmse=0.04 --fail-above mae=0.2");
    CHECK(ran.exit_code == 1);
    CHECK(ran.err == "plumbline: rmse is 0.1, above 0.04 by 0.06\n");
    CHECK(run(files, "--fail-above rmse=0.2 " + files.both).exit_code == 0);
}

TEST_CASE("compare -o writes the maps as EXR and PNG", "[compare]") {
    const Files files;
    const auto folder = files.path / "maps";
    REQUIRE(run(files, files.both + " -o " + folder.string()).exit_code == 0);
    const Image maps = read_image(folder / "error_maps.exr");
    CHECK(maps.layer("signed")[1][5] == Approx(0.1f));
    CHECK(maps.layer("absolute")[2][7] == Approx(0.1f));
    CHECK(maps.has_channel("flip.Y"));
    for (const char* name : {"absolute.png", "signed.png", "relative.png", "flip.png"})
        CHECK(read_image(folder / name).width() >= 16);
}

TEST_CASE("compare of two sequences gives the error over frames", "[compare]") {
    const Files files;
    for (int frame : {8, 9, 10}) {
        const auto name = [&](const char* which) {
            return files.path / (std::string(which) + (frame < 10 ? ".000" : ".00") +
                                 std::to_string(frame) + ".exr");
        };
        const auto flat = [](float value) { return [=](int, int, int) { return value; }; };
        write_exr(name("a"), image_of(12, 12, flat(0.5f)));
        write_exr(name("b"), image_of(12, 12, flat(0.5f + 0.01f * float(frame))));
    }
    const std::string both =
        (files.path / "a.####.exr").string() + " " + (files.path / "b.####.exr").string();
    const auto folder = files.path / "over";
    const Ran ran = run(files, both + " --json -o " + folder.string() + " --fail-above rmse=0.095");
    CHECK(ran.exit_code == 1);
    CHECK_THAT(ran.err, Catch::StartsWith("plumbline: frame 10: rmse is 0.1"));
    const auto json = nlohmann::json::parse(ran.out);
    REQUIRE(json.at("frames").size() == 3);
    CHECK(json["frames"][0]["frame"] == 8);
    CHECK(json["frames"][1]["metrics"]["bias"].get<double>() == Approx(0.09).epsilon(1e-5));
    CHECK(json["over_frames"]["rmse"]["mean"].get<double>() == Approx(0.09).epsilon(1e-5));
    CHECK(json["over_frames"]["rmse"]["largest_frame"] == 10);
    const std::string csv = text_of(folder / "errors.csv");
    CHECK(std::count(csv.begin(), csv.end(), '\n') == 4);
    CHECK_THAT(csv, Catch::StartsWith("frame,bias,mae,rmse,"));
    CHECK(read_image(folder / "0009" / "error_maps.exr").has_layer("signed"));

    std::filesystem::remove(files.path / "b.0009.exr");
    const Ran missing = run(files, both);
    CHECK(missing.exit_code == 2);
    CHECK_THAT(missing.err, Catch::Contains("no file for frame 9"));
    CHECK(run(files,
              (files.path / "a.####.exr").string() + " " + (files.path / "b.0008.exr").string())
              .exit_code == 2);
}

TEST_CASE("compare resamples only when asked and then says so", "[compare]") {
    const Files files;
    const std::string pair =
        (files.path / "r.exr").string() + " " + (files.path / "s.exr").string();
    CHECK(run(files, pair).exit_code == 2);
    const Ran ran = run(files, pair + " --resample --json");
    REQUIRE(ran.exit_code == 0);
    CHECK_THAT(ran.err, Catch::Contains("resampled from 12x12 to 16x12"));
    CHECK(nlohmann::json::parse(ran.out).at("notes").size() == 1);
}

TEST_CASE("compare --half tells noise without variance layers", "[compare]") {
    const Files files;
    write_exr(files.path / "n1.exr", noise_image(64, 64, 1, 1.f));
    write_exr(files.path / "n2.exr", noise_image(64, 64, 2, 1.f));
    write_exr(files.path / "flat.exr", image_of(64, 64, [](int, int, int) { return 0.5f; }));
    const Ran ran =
        run(files, (files.path / "flat.exr").string() + " " + (files.path / "n1.exr").string() +
                       " --json --half " + (files.path / "n2.exr").string());
    REQUIRE(ran.exit_code == 0);
    const auto noise = nlohmann::json::parse(ran.out).at("noise");
    CHECK(noise.at("method") == "independent halves");
    CHECK(noise.at("mse_expected_from_noise").get<double>() == Approx(1.0 / 12).epsilon(0.05));
    CHECK(noise.at("bias_mse_ci95")[0].get<double>() < 0);
    CHECK(noise.at("bias_mse_ci95")[1].get<double>() > 0);
    CHECK(noise.at("bias_mse_ci95")[1].get<double>() < 0.01);
}

TEST_CASE("compare refuses what it cannot compare with one line and exit code 2", "[compare]") {
    const Files files;
    const std::string r = (files.path / "r.exr").string();
    const std::map<std::string, std::string> refusals{
        {files.both + " --layer indirect", "no layer 'indirect'"},
        {files.both + " --fail-above rsme=1", "no metric 'rsme'"},
        {files.both + " --fail-above rmse=x", "has no number"},
        {files.both + " --fail-above rmse", "has no number"},
        {files.both + " --tone-mapper gamma", "aces, hable or reinhard"},
        {r + " " + (files.path / "s.exr").string(), "12x12 but the reference is 16x12"},
        {r + " " + (files.path / "none.exr").string(), "no such file"},
    };
    for (const auto& [arguments, says] : refusals) {
        const Ran ran = run(files, arguments);
        CHECK(ran.exit_code == 2);
        CHECK(ran.out.empty());
        CHECK_THAT(ran.err, Catch::Contains(says));
        CHECK(std::count(ran.err.begin(), ran.err.end(), '\n') == 1);
    }
}

TEST_CASE("an undefined metric fails its threshold", "[compare]") {
    const Threshold threshold = parse_threshold("flip=0.5");
    CHECK(exceeded({threshold}, Metrics{}).size() == 1);
    Metrics metrics;
    metrics.flip = 0.5;
    CHECK(exceeded({threshold}, metrics).empty());
}
