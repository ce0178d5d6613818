// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "reports/output_folder.h"
#include "reports/stress.h"
#include "reports/study_page.h"
#include "reports/words.h"
#include "scenes/command_line.h"
#include "scenes/errors.h"
#include "scenes/nearest_name.h"
#include "scenes/output_path.h"

namespace plumbline {
namespace {

struct StressOptions {
    CommonOptions common;
    std::string only;
    std::filesystem::path folder;
    bool json = false;
};

std::string page_of(const std::vector<reports::CaseResult>& results, const StressOptions& options) {
    reports::StudyPage page;
    page.title = "Hard cases stay numerically stable";
    page.command = "plumbline stress";
    if (!options.only.empty()) page.command += " --only " + reports::shell_word(options.only);
    page.command += " -o " + reports::shell_word(options.folder.string());
    page.sections = {reports::stress_section(results)};
    return reports::study_html(page);
}

void run(const StressOptions& options) {
    const auto threads = options.common.apply();
    if (!options.folder.empty()) check_output_folder(options.folder);
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
    std::FILE* const terminal = options.json ? stderr : stdout;
    const std::vector<reports::CaseResult> results =
        reports::run_cases(cases, [&](const reports::CaseResult& result) {
            fmt::print(terminal, "{}", reports::to_text(result));
            static_cast<void>(std::fflush(terminal));  // into a pipe too, line by line
        });
    const std::string json = reports::to_json(results).dump(2) + "\n";
    if (options.json) fmt::print("{}", json);
    if (!options.folder.empty())
        reports::write_folder(options.folder,
                              {{"stress.json", json}, {"index.html", page_of(results, options)}});
    if (!reports::all_passed(results)) exit_code = 1;
}

}  // namespace

void add_stress_command(CLI::App& app) {
    CLI::App& command = *app.add_subcommand(
        "stress", "Hard cases that must stay numerically stable; exit 1 if one does not");
    const auto options = std::make_shared<StressOptions>();
    add_common_options(command, options->common);
    command.add_option("--only", options->only, "Cases with this text in their name or group");
    command.add_option("-o,--output", options->folder, "Folder for index.html and stress.json");
    command.add_flag("--json", options->json, "Findings as JSON on stdout");
    command.callback([options] { run(*options); });
}

}  // namespace plumbline
