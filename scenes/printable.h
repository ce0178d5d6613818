// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace plumbline {

/// `text` on one line of valid UTF-8: control characters, and bytes that are no UTF-8, as \xNN.
/// Files of other encodings keep names that can be told apart, and no file writes to the terminal.
std::string printable(std::string_view text);

/// A library's message, which may span lines or be missing, as a part of ours.
std::string one_line(std::string text);

}  // namespace plumbline
