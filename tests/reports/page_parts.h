// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace plumbline::reports {

/// The page without the text of its script elements.
std::string without_scripts(const std::string& html);

/// What stands between the tags of the script element with this id.
std::string script_text(const std::string& html, const std::string& id);

/// The JSON that the page's scripts work on.
nlohmann::json page_json(const std::string& html);

/// How often `part` occurs in `text`.
std::size_t count(const std::string& text, const std::string& part);

std::vector<unsigned char> bytes_from_base64(const std::string& text);

/// The floats of packed planes: a second formulation of reports/page/layers.js.
std::vector<float> unpacked(const std::string& base64, int width, int exponent);

}  // namespace plumbline::reports
