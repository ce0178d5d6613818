// SPDX-License-Identifier: Apache-2.0
#include "reports/words.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace plumbline::reports {

std::string number_text(double value) {
    const double magnitude = std::abs(value);
    if (!std::isfinite(value) || value == 0) return fmt::format("{}", value);
    std::string scientific = fmt::format("{:.2e}", value);
    if (magnitude >= 1e5 || magnitude < 1e-4) return scientific;
    // The exponent after rounding: 0.00999999 has that of 0.0100.
    const int exponent = std::stoi(scientific.substr(scientific.find('e') + 1));
    return fmt::format("{:.{}f}", value, std::max(0, 2 - exponent));
}

std::string count_text(std::uint64_t count) {
    constexpr const char* thin_space = "\u2009";
    std::string digits = std::to_string(count);
    for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, thin_space);
    return digits;
}

std::string duration_text(double seconds) {
    if (!(seconds >= 0)) return "unknown";
    if (seconds < 1e-3) return number_text(1e6 * seconds) + " \u00b5s";
    if (seconds < 1) return number_text(1e3 * seconds) + " ms";
    if (seconds < 60) return number_text(seconds) + " s";
    const auto whole = std::llround(seconds);
    if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
    return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

std::string percent_text(double share) {
    const double percent = 100 * share;
    const double magnitude = std::abs(percent);
    const bool nearly_all = magnitude >= 99.5 && magnitude < 100;
    if (magnitude >= 10 && !nearly_all) return fmt::format("{:.0f} %", percent);
    if (nearly_all) return fmt::format("{:.2f} %", percent);
    return fmt::format("{:.{}f} %", percent, magnitude >= 1 ? 1 : 2);
}

std::string ratio_words(double ratio) {
    // Beyond a third, "times" reads easier than per cent.
    constexpr double near = 4. / 3.;
    if (!std::isfinite(ratio) || ratio <= 0) return "of no meaningful brightness";
    const std::string side = ratio > 1 ? "too bright" : "too dark";
    if (std::max(ratio, 1 / ratio) > near)
        return fmt::format("{} times {}", number_text(std::max(ratio, 1 / ratio)), side);
    return fmt::format("{} {}", percent_text(std::abs(ratio - 1)), side);
}

std::string shell_word(const std::string& text) {
    const auto plain = [](unsigned char c) {
        return std::isalnum(c) != 0 || c == '.' || c == '_' || c == '/' || c == '-' || c == '=';
    };
    if (!text.empty() && std::all_of(text.begin(), text.end(), plain)) return text;
    std::string quoted = "'";
    for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

}  // namespace plumbline::reports
