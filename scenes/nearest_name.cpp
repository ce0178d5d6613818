// SPDX-License-Identifier: Apache-2.0
#include "scenes/nearest_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "scenes/printable.h"

namespace plumbline {
namespace {

constexpr std::size_t longest_shown = 60;
constexpr std::size_t most_listed = 12;

/// Insertions, deletions and replacements that turn `a` into `b` [Wagner and Fischer 1974].
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i + 1);
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = std::exchange(row[j + 1], std::min({row[j] + 1, row[j + 1] + 1, replaced}));
        }
    }
    return row[b.size()];
}

std::string listed(std::span<const std::string> known) {
    std::string text;
    for (const std::string& name : known.first(std::min(known.size(), most_listed))) {
        text += (text.empty() ? "" : ", ") + in_quotes(name);
    }
    return known.size() > most_listed
               ? text + fmt::format(" and {} more", known.size() - most_listed)
               : text;
}

}  // namespace

std::string in_quotes(std::string_view text) {
    std::string shown(text);
    if (shown.size() > longest_shown) {
        shown.replace(longest_shown / 2, shown.size() - 2 * (longest_shown / 2), "...");
    }
    return '"' + printable(shown) + '"';
}

std::string did_you_mean(std::string_view name, std::span<const std::string> known) {
    const std::string* nearest = nullptr;
    std::size_t least = std::max<std::size_t>(2, name.size() / 3) + 1;
    for (const std::string& candidate : known) {
        const std::size_t longer = std::max(candidate.size(), name.size());
        const std::size_t shorter = std::min(candidate.size(), name.size());
        // The distance is at least the difference in length: most names need no table.
        if (longer > longest_shown || longer - shorter >= least) continue;
        const std::size_t distance = edit_distance(name, candidate);
        if (distance < least && distance < longer) {
            least = distance;
            nearest = &candidate;
        }
    }
    if (nearest != nullptr) return "did you mean " + in_quotes(*nearest) + "?";
    return known.empty() ? "there are none" : "known are " + listed(known);
}

}  // namespace plumbline
