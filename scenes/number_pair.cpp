// SPDX-License-Identifier: Apache-2.0
#include "scenes/number_pair.h"

#include <charconv>

namespace plumbline {

std::optional<glm::ivec2> parsed_pair(std::string_view text, char between) {
    glm::ivec2 pair(0);
    const char* const end = text.data() + text.size();
    const auto first = std::from_chars(text.data(), end, pair.x);
    if (first.ec != std::errc() || first.ptr == end || *first.ptr != between) return std::nullopt;
    const auto second = std::from_chars(first.ptr + 1, end, pair.y);
    if (second.ec != std::errc() || second.ptr != end || pair.x < 1 || pair.y < 1)
        return std::nullopt;
    return pair;
}

}  // namespace plumbline
