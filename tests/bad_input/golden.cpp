// SPDX-License-Identifier: Apache-2.0
#include "tests/bad_input/golden.h"

#include <filesystem>
#include <stdexcept>

#include "scenes/input_files.h"

namespace plumbline {
namespace {

using nlohmann::json;

const std::filesystem::path here = std::filesystem::path(PLUMBLINE_SOURCE_DIR) / "tests/bad_input";

/// A file of a case: its text, or one of the good files here with a part replaced or its end cut.
std::string content(const json& told) {
    if (told.is_string()) return told;
    std::string text = read_bytes(here / told.at("base").get<std::string>());
    if (told.contains("cut")) return text.substr(0, told.at("cut"));
    const std::string from = told.at("replace")[0];
    const std::size_t at = text.find(from);
    if (at == std::string::npos) throw std::logic_error("no such part to replace: " + from);
    return text.replace(at, from.size(), told.at("replace")[1].get<std::string>());
}

}  // namespace

json bad_inputs() { return json::parse(read_bytes(here / "golden.json")); }

std::map<std::string, std::string> bad_files(const json& bad) {
    std::map<std::string, std::string> files;
    for (const auto& [name, told] : bad.at("files").items()) files[name] = content(told);
    return files;
}

}  // namespace plumbline
