// SPDX-License-Identifier: Apache-2.0
// Bad input of every kind, each with the one line that it must get: golden.json.
#include <sys/wait.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>

#include "scenes/input_files.h"
#include "tests/bad_input/golden.h"
#include "tests/scenes/temporary_folder.h"

using namespace plumbline;
using nlohmann::json;

namespace {

std::string quoted(const std::string& word) {
    std::string result = "'";
    for (const char c : word) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

std::set<std::string> files_in(const std::filesystem::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        names.insert(entry.path().filename().string());
    }
    return names;
}

void check_case(const json& bad) {
    const TemporaryFolder work;
    const TemporaryFolder streams;
    for (const auto& [name, text] : bad_files(bad)) work.write(name, text);
    const std::set<std::string> before = files_in(work.path());
    std::string command = "cd " + quoted(work.path().string()) + " && " + quoted(PLUMBLINE_BINARY);
    for (const std::string word : bad.at("arguments")) command += " " + quoted(word);
    command +=
        " >" + quoted((streams / "out").string()) + " 2>" + quoted((streams / "err").string());
    const int status = std::system(command.c_str());
    INFO(bad.dump());
    CHECK(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 2);
    CHECK(read_bytes(streams / "out").empty());
    CHECK(read_bytes(streams / "err") == "plumbline: " + bad.at("line").get<std::string>() + "\n");
    CHECK(files_in(work.path()) == before);
}

void check_group(const std::string& group) {
    int count = 0;
    for (const json& bad : bad_inputs()) {
        if (bad.at("group") != group) continue;
        check_case(bad);
        ++count;
    }
    CHECK(count > 0);
}

}  // namespace

TEST_CASE("bad scenes get their line and exit code 2 and leave no file", "[bad-input]") {
    check_group("scene");
}

TEST_CASE("bad glTF files get their line and exit code 2 and leave no file", "[bad-input]") {
    check_group("gltf");
}

TEST_CASE("bad OBJ files get their line and exit code 2 and leave no file", "[bad-input]") {
    check_group("obj");
}

TEST_CASE("bad pictures get their line and exit code 2 and leave no file", "[bad-input]") {
    check_group("image");
}

TEST_CASE("bad command lines get their line and exit code 2 and leave no file", "[bad-input]") {
    check_group("command line");
}
