// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "reports/commands.h"
#include "reports/leak_page.h"
#include "reports/output_folder.h"
#include "reports/words.h"
#include "scenes/command_line.h"
#include "scenes/output_path.h"

namespace plumbline {

namespace {

struct Options {
    CommonOptions common;
    std::filesystem::path folder;
    reports::LeakOptions leak;
    bool json = false;
};

std::string command_of(const Options& options) {
    return fmt::format("plumbline leak --cells {} --size {}x{} -o {}",
                       fmt::join(options.leak.cells, ","), options.leak.width, options.leak.height,
                       reports::shell_word(options.folder.string()));
}

void run(Options& options) {
    const auto threads = options.common.apply();
    check_output_folder(options.folder);
    options.leak.width = options.common.width.value_or(options.leak.width);
    options.leak.height = options.common.height.value_or(options.leak.height);
    const auto curves = reports::measure_leak(reports::leak_cases(), options.leak);
    const std::string results = reports::leak_json(curves).dump(2) + "\n";
    reports::write_folder(
        options.folder,
        {{"leak.json", results},
         {"index.html", reports::study_html(reports::leak_page(curves, command_of(options)))}});
    if (options.json) fmt::print("{}", results);
}

}  // namespace

void add_leak_command(CLI::App& app) {
    CLI::App& command = *app.add_subcommand(
        "leak", "Measures what the probes of every model let through a wall, by its thickness");
    const auto options = std::make_shared<Options>();
    command.add_option("-o,--output", options->folder, "Folder for index.html and leak.json")
        ->required();
    add_common_options(command, options->common);
    command.remove_option(command.get_option("--frame"));
    command
        .add_option("--cells", options->leak.cells,
                    "Thicknesses of the wall in spacings of the probes, comma-separated "
                    "(default: 0 to 1 in nine steps)")
        ->delimiter(',');
    command.add_flag("--json", options->json, "Print leak.json on stdout too");
    command.callback([options] { run(*options); });
}

}  // namespace plumbline
