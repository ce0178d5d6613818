// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <vector>

#include "scenes/command_line.h"
#include "scenes/nearest_name.h"
#include "scenes/printable.h"

namespace plumbline {
namespace {

std::vector<std::string> subcommand_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
    return names;
}

std::vector<std::string> option_names(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    return names;
}

/// The word that nobody asked for: an option that does not exist, before what may be its value.
std::string unexpected(const std::vector<std::string>& words) {
    for (const std::string& word : words) {
        if (word.starts_with("--")) return word;
    }
    return words.front();
}

std::string unexpected_line(const CLI::App& command, const std::vector<std::string>& words) {
    const std::string word = unexpected(words);
    if (word.starts_with('-')) {
        return fmt::format("there is no option {}; {}", in_quotes(word),
                           did_you_mean(word, option_names(command)));
    }
    return fmt::format("{} is one argument too many; leave it out", in_quotes(word));
}

/// "Could not convert: --seed = x" is said in our words; the parser's other texts do as they are.
std::string problem_of(const CLI::ParseError& error) {
    std::string text = error.what();
    const std::string could_not = "Could not convert: ";
    const std::size_t equals = text.find(" = ");
    if (text.starts_with(could_not) && equals != std::string::npos) {
        return fmt::format("{}: {} is no number that it takes",
                           text.substr(could_not.size(), equals - could_not.size()),
                           in_quotes(text.substr(equals + 3)));
    }
    return text;
}

/// The line, with whatever the words have in them.
std::string told(const CLI::App& app, const CLI::ParseError& error) {
    const std::vector<CLI::App*> parsed = app.get_subcommands();
    if (parsed.empty()) {
        const std::vector<std::string> words = app.remaining();
        if (words.empty()) {
            return "no subcommand is given; " + did_you_mean("", subcommand_names(app));
        }
        return fmt::format("there is no subcommand {}; {}", in_quotes(words.front()),
                           did_you_mean(words.front(), subcommand_names(app)));
    }
    const CLI::App& command = *parsed.back();
    const std::vector<std::string> words = command.remaining();
    if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr && !words.empty()) {
        return fmt::format("{}: {}", command.get_name(), unexpected_line(command, words));
    }
    return fmt::format("{0}: {1}; plumbline {0} --help tells what it takes", command.get_name(),
                       problem_of(error));
}

}  // namespace

std::string usage_line(const CLI::App& app, const CLI::ParseError& error) {
    return printable(told(app, error));
}

}  // namespace plumbline
