// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace plumbline {

/// The cases of golden.json, each with "group", "files", "arguments" and "line".
nlohmann::json bad_inputs();

/// A case's files: name and bytes.
std::map<std::string, std::string> bad_files(const nlohmann::json& bad);

}  // namespace plumbline
