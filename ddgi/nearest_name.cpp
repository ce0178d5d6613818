// SPDX-License-Identifier: Apache-2.0
#include "ddgi/nearest_name.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <numeric>

namespace plumbline::ddgi {
namespace {

int lower(char c) { return std::tolower(static_cast<unsigned char>(c)); }

/// Levenshtein's distance, blind to case.
std::size_t edit_distance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t substituted = diagonal + (lower(a[i]) == lower(b[j]) ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({substituted, row[j] + 1, diagonal + 1});
        }
    }
    return row.back();
}

}  // namespace

std::string choices(const std::string& typed, const std::vector<std::string>& names) {
    const auto nearest = std::ranges::min_element(
        names, {}, [&](const std::string& name) { return edit_distance(typed, name); });
    const std::string all = fmt::format("there are {}", fmt::join(names, ", "));
    // Further away than half the word it is another word, not a slip.
    if (nearest == names.end() || edit_distance(typed, *nearest) * 2 > nearest->size()) return all;
    return fmt::format("did you mean '{}'? {}", *nearest, all);
}

}  // namespace plumbline::ddgi
