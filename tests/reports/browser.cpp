// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>

#include "reports/page.h"
#include "tests/reports/page_parts.h"
#include "tests/reports/synthetic_report.h"

using namespace plumbline;
using namespace plumbline::reports;
namespace fs = std::filesystem;

namespace {

std::string output_of(const std::string& command) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(::popen(command.c_str(), "r"),
                                                               ::pclose);
    REQUIRE(pipe != nullptr);
    std::string output;
    std::array<char, 4096> buffer{};
    while (const std::size_t read = std::fread(buffer.data(), 1, buffer.size(), pipe.get()))
        output.append(buffer.data(), read);
    return output;
}

std::string text_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// A folder of this test's own, gone with it.
struct Folder {
    fs::path path = fs::temp_directory_path() / ("plumbline-browser-" + std::to_string(::getpid()));
    Folder() { fs::create_directories(path); }
    ~Folder() {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
};

/// Holds the page as wide as it is asked for, which Chromium's own windows are not below 500
/// pixels, and shows what it tells.
std::string frame_around(const std::string& page, int width) {
    return "<iframe src=\"" + page + "\" style=\"width:" + std::to_string(width) +
           "px;height:900px;border:0\"></iframe><script>addEventListener(\"message\", ({ data }) "
           "=> "
           "{ const seen = document.createElement(\"pre\"); seen.id = \"seen\"; "
           "seen.textContent = data; document.body.append(seen); });</script>";
}

/// What a page around `html` shows after all scripts ran, from headless Chromium; what the console
/// said in `console`.
std::string page_in_browser(const std::string& html, int width, std::string& console) {
    const Folder folder;
    std::ofstream(folder.path / "page.html") << html;
    const fs::path page = folder.path / "frame.html";
    std::ofstream(page) << frame_around("page.html", width);
    const fs::path log = folder.path / "log";
    const std::string dom = output_of(
        "timeout 120 chromium --headless --no-sandbox --disable-gpu --disable-quic --no-first-run "
        "--disable-background-networking --disable-component-update --disable-sync "
        "--virtual-time-budget=20000 --enable-logging=stderr --dump-dom --user-data-dir=" +
        (folder.path / "profile").string() + " --window-size=1400,1000 file://" + page.string() +
        " 2>" + log.string());
    console.clear();
    std::ifstream lines(log);
    for (std::string line; std::getline(lines, line);)
        if (line.find("CONSOLE") != std::string::npos) console += line + "\n";
    return dom;
}

bool chromium_is_here() { return !output_of("command -v chromium").empty(); }

nlohmann::json what_the_page_showed(int width) {
    std::string html = page_html(synthetic_report(64, 36));
    const std::string driver =
        "<script>" + text_of(fs::path(PLUMBLINE_SOURCE_DIR) / "tests/reports/drive_page.js") +
        "</script></body>";
    html.replace(html.rfind("</body>"), std::string("</body>").size(), driver);
    std::string console;
    const std::string dom = page_in_browser(html, width, console);
    CHECK(console == "");
    const std::size_t at = dom.rfind("<pre id=\"seen\">");
    REQUIRE(at != std::string::npos);
    const std::size_t begin = dom.find('>', at) + 1;
    return nlohmann::json::parse(dom.substr(begin, dom.find("</pre>", begin) - begin));
}

}  // namespace

TEST_CASE("in a browser every control of the page does what it says", "[reports][browser]") {
    if (!chromium_is_here()) {
        WARN("skipped: Debian's package chromium is not installed");
        return;
    }
    const nlohmann::json seen = what_the_page_showed(1280);
    CAPTURE(seen.dump(1));
    for (const char* control :
         {"exposure", "reset", "zoom", "pan", "wipe", "flip", "side", "layer", "map", "theme"}) {
        CAPTURE(control);
        CHECK(seen[control] == true);
    }
    CHECK(seen["exposure_text"] == "+0.5 stops");
    CHECK(seen["caption"] == "Pixel 32, 18");
    CHECK(seen["cursor"] == "Pixel 33, 19");
    CHECK(seen["flip_name"] == "B: conserving");
    CHECK(seen["bars"].size() == 3);
    CHECK(seen["least_ratio"] == "thesis");
    CHECK(seen["sorted"] == "descending");
    CHECK(seen["charts"] == nlohmann::json({5, 2}));
    // The error by scale: each picture's line and its line of noise. The animation: a line a model.
    REQUIRE(seen["studies"].size() == 2);
    CHECK(seen["studies"][0].size() == 8);
    CHECK(seen["studies"][1][0] == nlohmann::json({"thesis", 3}));
    REQUIRE(seen["hover"].size() >= 1);
    CHECK(seen["hover"][0] == "thesis: 275, 0.387");
    CHECK(seen["wide"] == false);
}

TEST_CASE("in a browser the pixel inspector shows the rendered values", "[reports][browser]") {
    if (!chromium_is_here()) {
        WARN("skipped: Debian's package chromium is not installed");
        return;
    }
    const nlohmann::json seen = what_the_page_showed(400);
    CHECK(seen["wide"] == false);
    const Report report = synthetic_report(64, 36);
    const SceneReport& scene = report.scenes[0];
    constexpr std::size_t pixel = 18 * 64 + 32;
    for (std::size_t c = 0; c < 3; ++c) {
        const auto shown = [&](std::size_t row) {
            return std::stod(seen["values"][row][c + 1].get<std::string>());
        };
        const double truth = std::as_const(scene.truth.image).layer("")[c][pixel];
        const double test = std::as_const(scene.models[2].result.image).layer("")[c][pixel];
        CHECK(shown(0) == Approx(truth).epsilon(1e-3));
        CHECK(shown(1) == Approx(test).epsilon(1e-3));
        CHECK(shown(2) == Approx(test - truth).margin(1e-3));
        CHECK(shown(3) == Approx(0.01).epsilon(1e-3));
    }
}
