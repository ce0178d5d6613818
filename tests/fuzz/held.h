// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>

#include "scenes/errors.h"

namespace plumbline::fuzz {

/// A message is one line without control characters, so that no file can write to the terminal
/// what it likes. Throws std::logic_error if it is not.
inline void hold_to_one_line(const std::string& line) {
    const auto is_control = [](char c) {
        return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
    };
    if (line.empty() || std::any_of(line.begin(), line.end(), is_control)) {
        throw std::logic_error("not a line to show: " + line);
    }
}

/// Calls `read`, which may refuse its input by an InputError of one line; true if it did not.
template <typename Read>
bool accepted(const Read& read) {
    try {
        read();
        return true;
    } catch (const InputError& error) {
        hold_to_one_line(error.what());
        return false;
    }
}

}  // namespace plumbline::fuzz
