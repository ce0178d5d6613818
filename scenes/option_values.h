// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/App.hpp>
#include <map>
#include <string>
#include <vector>

namespace plumbline {

/// Throws UsageError: `word` is none of `known`.
[[noreturn]] void fail_choice(const std::string& option, const std::string& word,
                              const std::vector<std::string>& known);

/// The value of `word` in `names`, upper and lower case alike. Throws UsageError, with the nearest
/// name, about `option`.
template <typename T>
T choice(const std::string& option, const std::string& word,
         const std::map<std::string, T>& names) {
    const std::string lower = CLI::detail::to_lower(word);
    if (const auto found = names.find(lower); found != names.end()) return found->second;
    std::vector<std::string> known;
    for (const auto& [name, value] : names) known.push_back(name);
    fail_choice(option, word, known);
}

/// Adds an option that takes one of these names. `value` must outlive the parse.
template <typename T>
void add_choice(CLI::App& command, const std::string& option, T& value,
                const std::map<std::string, T>& names, const std::string& what) {
    command.add_option_function<std::string>(
        option,
        [&value, names, option](const std::string& word) { value = choice(option, word, names); },
        what);
}

/// Numbers above 0, and those from `least` to `most`. The parser itself reads "nan" and "inf" as
/// numbers: neither is taken.
CLI::Validator above_zero();
CLI::Validator from_to(double least, double most);

}  // namespace plumbline
