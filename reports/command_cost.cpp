// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "ddgi/model.h"
#include "reports/commands.h"
#include "reports/cost_page.h"
#include "reports/output_folder.h"
#include "reports/words.h"
#include "scenes/command_line.h"
#include "scenes/output_path.h"

namespace plumbline {

namespace {

struct Options {
    CommonOptions common;
    std::string scene;
    std::filesystem::path folder;
    reports::CostOptions cost;
    bool json = false;
};

std::string command_of(const Options& options) {
    return fmt::format("plumbline cost {} --model {} --spacings {:.6g} --repeats {} -o {}",
                       reports::shell_word(options.scene), options.cost.model,
                       fmt::join(options.cost.spacings, ","), options.cost.repeats,
                       reports::shell_word(options.folder.string()));
}

void run(const Options& options) {
    const auto threads = options.common.apply();
    check_output_folder(options.folder);
    const Scene scene = load_scene_for(options.scene, options.common);
    const reports::CostStudy study = reports::measure_cost(scene, options.cost);
    const std::string results = reports::cost_json(study, scene.name).dump(2) + "\n";
    reports::write_folder(options.folder,
                          {{"cost.json", results},
                           {"index.html", reports::study_html(reports::cost_page(
                                              study, scene.name, command_of(options)))}});
    if (options.json) fmt::print("{}", results);
}

}  // namespace

void add_cost_command(CLI::App& app) {
    CLI::App& command =
        *app.add_subcommand("cost", "Times probes against their number and that of their surfels");
    const auto options = std::make_shared<Options>();
    command.add_option("scene", options->scene, "Built-in name, or .json, .gltf, .glb file")
        ->required();
    command.add_option("-o,--output", options->folder, "Folder for index.html and cost.json")
        ->required();
    add_common_options(command, options->common);
    command.add_option(
        "--model", options->cost.model,
        fmt::format("{} (default: {})", fmt::join(ddgi::model_names(), ", "), options->cost.model));
    command
        .add_option("--spacings", options->cost.spacings,
                    "Distances between probes, comma-separated (default: 40, 20, 13.3, 10, 8, 5); "
                    "half the distance takes eight times the memory")
        ->delimiter(',');
    command.add_option("--repeats", options->cost.repeats,
                       "Runs of which the least time counts (default: 3)");
    command.add_flag("--json", options->json, "Print cost.json on stdout too");
    command.callback([options] { run(*options); });
}

}  // namespace plumbline
