// SPDX-License-Identifier: Apache-2.0
// Bad input of every kind, each with the one line that it must get: golden.json.
#include <sys/wait.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/scenes/temporary_folder.h"

using namespace plumbline;
using nlohmann::json;

namespace {

const std::filesystem::path here = std::filesystem::path(PLUMBLINE_SOURCE_DIR) / "tests/bad_input";

std::string text_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// A file of a case: its text, or one of the good files here with a part replaced or its end cut.
std::string content(const json& told) {
    if (told.is_string()) return told;
    std::string text = text_of(here / told.at("base").get<std::string>());
    if (told.contains("cut")) return text.substr(0, told.at("cut"));
    const std::string from = told.at("replace")[0];
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), told.at("replace")[1].get<std::string>());
}

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
    for (const auto& [name, told] : bad.at("files").items()) work.write(name, content(told));
    const std::set<std::string> before = files_in(work.path());
    std::string command = "cd " + quoted(work.path().string()) + " && " + quoted(PLUMBLINE_BINARY);
    for (const std::string word : bad.at("arguments")) command += " " + quoted(word);
    command +=
        " >" + quoted((streams / "out").string()) + " 2>" + quoted((streams / "err").string());
    const int status = std::system(command.c_str());
    INFO(bad.dump());
    CHECK(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 2);
    CHECK(text_of(streams / "out").empty());
    CHECK(text_of(streams / "err") == "plumbline: " + bad.at("line").get<std::string>() + "\n");
    CHECK(files_in(work.path()) == before);
}

void check_group(const std::string& group) {
    const json cases = json::parse(text_of(here / "golden.json"));
    int count = 0;
    for (const json& bad : cases) {
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
