// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace plumbline::reports {

/// Three significant digits: 0.0471, 12.4, 1.25e-05.
std::string number_text(double value);

/// Whole numbers with thin spaces between thousands: 2 097 152.
std::string count_text(std::uint64_t count);

/// A time with its unit: 380 us, 12.4 ms, 3.21 s, 2 min 5 s.
std::string duration_text(double seconds);

/// A share as a percentage: 94 %, 4.2 %, and near the whole 99.87 %.
std::string percent_text(double share);

/// How a mean stands to the true one, in words: "0.6 % too bright", "13.0 times too dark".
std::string ratio_words(double ratio);

/// As one word of a POSIX shell's command line.
std::string shell_word(const std::string& text);

}  // namespace plumbline::reports
