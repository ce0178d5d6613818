// SPDX-License-Identifier: Apache-2.0
#include "scenes/command_line.h"

#include <vector>

#include "compare/commands.h"
#include "ddgi/commands.h"
#include "pathtracer/commands.h"
#include "reports/commands.h"
#include "scenes/commands.h"
#include "tests/fuzz/held.h"
#include "tests/fuzz/targets.h"

namespace plumbline::fuzz {
namespace {

std::vector<std::string> split(Bytes words) {
    std::vector<std::string> result(1, "plumbline");
    for (auto from = words.begin(); from < words.end();) {
        const auto to = std::find(from, words.end(), std::uint8_t{0});
        result.emplace_back(from, to);
        from = to == words.end() ? to : to + 1;
    }
    return result;
}

}  // namespace

void command_line(Bytes words) {
    CLI::App app("", "plumbline");
    app.require_subcommand(1);
    app.set_version_flag("--version", PLUMBLINE_VERSION);
    add_scenes_commands(app);
    add_pathtracer_commands(app);
    add_ddgi_commands(app);
    add_compare_commands(app);
    add_reports_commands(app);
    // Called before any command's callback, which cannot be replaced: it owns the options' values.
    app.parse_complete_callback([] { throw CLI::Success(); });
    const std::vector<std::string> texts = split(words);
    std::vector<const char*> arguments;
    for (const std::string& text : texts) arguments.push_back(text.c_str());
    accepted([&] {
        try {
            app.parse(static_cast<int>(arguments.size()), arguments.data());
        } catch (const CLI::ParseError& error) {
            if (error.get_exit_code() != 0) hold_to_one_line(usage_line(app, error));
        }
    });
}

}  // namespace plumbline::fuzz
