// SPDX-License-Identifier: Apache-2.0
#include "scenes/printable.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

namespace plumbline {
namespace {

/// How many bytes the character at the beginning of `text` takes in UTF-8; 0 if they are none
/// [RFC 3629, section 4]: too long a form, half of a surrogate pair, or past the last code point.
std::size_t character_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
    const std::uint8_t first = byte(0);
    if (first < 0x80) return 1;
    const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    if (first < 0xc2 || first > 0xf4 || text.size() < length) return 0;
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xc0) != 0x80) return 0;
    }
    const bool too_long = (first == 0xe0 && byte(1) < 0xa0) || (first == 0xf0 && byte(1) < 0x90);
    const bool surrogate = first == 0xed && byte(1) > 0x9f;
    const bool past_last = first == 0xf4 && byte(1) > 0x8f;
    return too_long || surrogate || past_last ? 0 : length;
}

/// A control character, of ASCII or of those that Unicode keeps at U+0080 to U+009F.
bool is_control(std::string_view character) {
    const auto first = static_cast<std::uint8_t>(character[0]);
    return first < 0x20 || first == 0x7f ||
           (first == 0xc2 && static_cast<std::uint8_t>(character[1]) < 0xa0);
}

}  // namespace

std::string printable(std::string_view text) {
    std::string line;
    while (!text.empty()) {
        const std::size_t length = character_length(text);
        const std::string_view character = text.substr(0, std::max<std::size_t>(length, 1));
        if (length > 0 && !is_control(character)) {
            line += character;
        } else {
            for (const char c : character) {
                line += fmt::format("\\x{:02x}", static_cast<std::uint8_t>(c));
            }
        }
        text.remove_prefix(character.size());
    }
    return line;
}

std::string one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    while (!text.empty() && text.back() == ' ') text.pop_back();
    return text.empty() ? "unknown reason" : text;
}

}  // namespace plumbline
