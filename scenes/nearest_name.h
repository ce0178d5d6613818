// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace plumbline {

/// `text` in quotes and on one line: control characters escaped, the middle of long texts left out.
std::string in_quotes(std::string_view text);

/// The cure for a name that does not exist: the nearest of `known` by edit distance if one is
/// near, else all of them (the first few if they are many).
std::string did_you_mean(std::string_view name, std::span<const std::string> known);

}  // namespace plumbline
