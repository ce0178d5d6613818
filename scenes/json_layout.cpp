// SPDX-License-Identifier: Apache-2.0
#include "scenes/json_layout.h"

namespace plumbline {
namespace {

constexpr std::size_t widest_line = 100;
constexpr std::size_t step = 4;
// Longer ones are not even tried on one line, which keeps the work linear in the text.
constexpr std::size_t most_on_a_line = 32;

/// On one line with spaces after commas and colons; stops early once `widest_line` is passed.
bool on_one_line(const nlohmann::ordered_json& json, std::string& line) {
    if (!json.is_structured()) {
        line += json.dump();
    } else if (json.size() > most_on_a_line) {
        return false;
    } else {
        line += json.is_array() ? "[" : "{";
        bool first = true;
        for (const auto& [key, value] : json.items()) {
            if (!first) line += ", ";
            first = false;
            if (json.is_object()) line += nlohmann::ordered_json(key).dump() + ": ";
            if (!on_one_line(value, line)) return false;
        }
        line += json.is_array() ? "]" : "}";
    }
    return line.size() <= widest_line;
}

}  // namespace

std::string laid_out(const nlohmann::ordered_json& json, std::size_t indent) {
    std::string line;
    if (!json.is_structured() || json.empty()) return json.dump();
    if (indent > 0 && on_one_line(json, line) && indent + line.size() <= widest_line) return line;
    std::string text = json.is_array() ? "[" : "{";
    const std::string margin(indent + step, ' ');
    bool first = true;
    for (const auto& [key, value] : json.items()) {
        text += first ? "\n" : ",\n";
        first = false;
        text += margin;
        if (json.is_object()) text += nlohmann::ordered_json(key).dump() + ": ";
        text += laid_out(value, indent + step);
    }
    return text + "\n" + std::string(indent, ' ') + (json.is_array() ? "]" : "}");
}

}  // namespace plumbline
