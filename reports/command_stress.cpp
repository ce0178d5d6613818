// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "reports/stress.h"
#include "scenes/command_line.h"
#include "scenes/errors.h"
#include "scenes/nearest_name.h"

namespace plumbline {
namespace {

struct StressOptions {
    CommonOptions common;
    std::string only;
    bool json = false;
};

void run(const StressOptions& options) {
    const auto threads = options.common.apply();
    std::vector<reports::HardCase> cases = reports::hard_cases();
    std::erase_if(cases, [&](const reports::HardCase& hard_case) {
        return hard_case.name.find(options.only) == std::string::npos &&
               hard_case.group.find(options.only) == std::string::npos;
    });
    if (cases.empty()) {
        throw UsageError("--only",
                         fmt::format("no case has {} in its name", in_quotes(options.only)),
                         "leave it out to run all");
    }
    exit_code = reports::stress(cases, options.json);
}

}  // namespace

void add_stress_command(CLI::App& app) {
    CLI::App& command = *app.add_subcommand(
        "stress", "Hard cases that must stay numerically stable; exit 1 if one does not");
    const auto options = std::make_shared<StressOptions>();
    add_common_options(command, options->common);
    command.add_option("--only", options->only, "Cases with this text in their name or group");
    command.add_flag("--json", options->json, "Findings as JSON on stdout");
    command.callback([options] { run(*options); });
}

}  // namespace plumbline
