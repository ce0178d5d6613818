// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "reports/commands.h"
#include "reports/frontier_page.h"
#include "reports/output_folder.h"
#include "reports/truth.h"
#include "reports/words.h"
#include "scenes/command_line.h"
#include "scenes/output_path.h"

namespace plumbline {

namespace {

struct Options {
    CommonOptions common;
    std::string scene;
    std::filesystem::path folder;
    std::string reference;
    std::optional<int> repeats;
    bool quick = false;
    bool json = false;

    reports::FrontierEffort effort() const { return reports::frontier_effort(quick); }
};

std::string command_of(const Options& options) {
    std::string command = "plumbline frontier " + reports::shell_word(options.scene);
    if (options.common.width)
        command += fmt::format(" --size {}x{}", *options.common.width, *options.common.height);
    if (options.common.frame) command += fmt::format(" --frame {}", *options.common.frame);
    if (options.common.threads > 0) command += fmt::format(" --threads {}", options.common.threads);
    if (!options.reference.empty())
        command += " --reference " + reports::shell_word(options.reference);
    if (options.repeats) command += fmt::format(" --repeats {}", *options.repeats);
    if (options.quick) command += " --quick";
    return command + " -o " + reports::shell_word(options.folder.string());
}

void run(const Options& options) {
    const auto threads = options.common.apply();
    check_output_folder(options.folder);
    Scene scene = load_scene_for(options.scene, options.common);
    const int frame = options.common.frame ? frame_of(scene, options.common) : scene.report_frame;
    const reports::FrontierOptions measured{options.effort().spp,
                                            reports::frontier_cases(scene, options.quick),
                                            options.repeats.value_or(options.effort().repeats)};
    reports::check(measured);
    const Image truth = reports::truth_of(
        scene, frame, {options.reference, options.effort().pixels, options.effort().truth_spp},
        options.common);
    const reports::Frontier frontier = reports::measure_frontier(scene, frame, truth, measured);
    const std::string results = reports::frontier_json(frontier).dump(2) + "\n";
    reports::write_folder(options.folder,
                          {{"frontier.json", results},
                           {"frontier.csv", reports::frontier_csv(frontier)},
                           {"index.html", reports::study_html(reports::frontier_page(
                                              frontier, command_of(options)))}});
    if (options.json) fmt::print("{}", results);
}

}  // namespace

void add_frontier_command(CLI::App& app) {
    CLI::App& command = *app.add_subcommand(
        "frontier", "Measures what accuracy costs in time, for the path tracer and all probes");
    const auto options = std::make_shared<Options>();
    command.add_option("scene", options->scene, "Built-in name, or .json, .gltf, .glb file")
        ->required();
    command
        .add_option("-o,--output", options->folder,
                    "Folder for index.html, frontier.csv and frontier.json")
        ->required();
    add_common_options(command, options->common);
    command.add_option("--reference", options->reference,
                       "EXR with the truth (default: path-traced with 4096 samples a pixel)");
    command.add_option("--repeats", options->repeats,
                       "Runs of each, of which the median counts (default: 3; 2 with --quick)");
    command.add_flag("--quick", options->quick,
                     "Smaller pictures, a noisier truth and fewer settings");
    command.add_flag("--json", options->json, "Print frontier.json on stdout too");
    command.callback([options] { run(*options); });
}

}  // namespace plumbline
