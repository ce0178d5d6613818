// SPDX-License-Identifier: Apache-2.0
// What fuzzing found once stays found: each target reads its corpus in every run of the suite.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "scenes/input_files.h"
#include "tests/fuzz/targets.h"

using namespace plumbline;

namespace {

void replay(const std::string& name, void (*target)(fuzz::Bytes)) {
    const auto folder = std::filesystem::path(PLUMBLINE_SOURCE_DIR) / "tests/fuzz/corpus" / name;
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    CHECK(!files.empty());
    for (const auto& file : files) {
        INFO(file);
        const std::string bytes = read_bytes(file);
        const std::vector<std::uint8_t> input(bytes.begin(), bytes.end());
        CHECK_NOTHROW(target(input));
    }
}

}  // namespace

TEST_CASE("scene files that once broke the reader are read or refused", "[fuzz]") {
    replay("scene_json", fuzz::scene_json);
}

TEST_CASE("glTF files that once broke the reader are read or refused", "[fuzz]") {
    replay("gltf", fuzz::gltf);
}

TEST_CASE("OBJ files that once broke the reader are read or refused", "[fuzz]") {
    replay("obj", fuzz::obj);
}

TEST_CASE("pictures that once broke the reader are read or refused", "[fuzz]") {
    replay("image", fuzz::image);
}

TEST_CASE("command lines that once broke the parser are read or refused", "[fuzz]") {
    replay("command_line", fuzz::command_line);
}
