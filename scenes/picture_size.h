// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <string_view>

namespace plumbline {

/// Width and height of "WIDTHxHEIGHT", in pixels; nothing if `text` is anything else, or a side is
/// below 1.
std::optional<glm::ivec2> parsed_picture_size(std::string_view text);

}  // namespace plumbline
