// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <string_view>

namespace plumbline {

/// Two whole numbers from 1 on with `between` between them, as in 480x270 or 1/4; nothing if `text`
/// is anything else.
std::optional<glm::ivec2> parsed_pair(std::string_view text, char between);

}  // namespace plumbline
