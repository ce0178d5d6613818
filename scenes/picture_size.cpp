// SPDX-License-Identifier: Apache-2.0
#include "scenes/picture_size.h"

#include <charconv>

namespace plumbline {

std::optional<glm::ivec2> parsed_picture_size(std::string_view text) {
    glm::ivec2 size(0);
    const char* const end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, size.x);
    if (width.ec != std::errc() || width.ptr == end || *width.ptr != 'x') return std::nullopt;
    const auto height = std::from_chars(width.ptr + 1, end, size.y);
    if (height.ec != std::errc() || height.ptr != end || size.x < 1 || size.y < 1)
        return std::nullopt;
    return size;
}

}  // namespace plumbline
