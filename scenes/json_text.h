// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace plumbline {

using Json = nlohmann::json;

/// JSON that was read, and where from.
struct JsonDocument {
    std::string source;  ///< file name, for messages
    Json root;
};

/// Parses JSON text. Throws SceneError with line:column if it is cut off or otherwise broken,
/// or holds a number that is no finite double; with a JSON pointer if a key stands twice in one
/// object, or if it is nested too deep to be a scene.
JsonDocument parse_json(const std::string& text, const std::string& source);

}  // namespace plumbline
