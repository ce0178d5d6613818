// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "ddgi/model.h"
#include "reports/commands.h"
#include "reports/output_folder.h"
#include "reports/picture_size.h"
#include "reports/sequence_page.h"
#include "reports/sequence_summary.h"
#include "reports/words.h"
#include "scenes/command_line.h"
#include "scenes/output_path.h"

namespace plumbline {

namespace {

/// Of a picture without --size: 240 x 135 at 16:9, a sixty-fourth of the published study's.
constexpr double default_pixels = 240. * 135.;

struct Options {
    CommonOptions common;
    std::string scene;
    std::filesystem::path folder;
    reports::SequenceOptions sequence;
    bool json = false;
};

std::string command_of(const Options& options, const Camera& camera) {
    return fmt::format(
        "plumbline sequence {} --model {} --frames {} --repeats {} --size {}x{} -o {}",
        reports::shell_word(options.scene), options.sequence.model, options.sequence.frames,
        options.sequence.repeats, camera.width, camera.height,
        reports::shell_word(options.folder.string()));
}

void run(const Options& options) {
    const auto threads = options.common.apply();
    check_output_folder(options.folder);
    Scene scene = load_scene_for(options.scene, options.common);
    reports::set_default_size(scene.camera, options.common, default_pixels);
    const reports::Sequence sequence = reports::measure_sequence(scene, options.sequence);
    const std::string summary = reports::summary_json(sequence, scene.name).dump(2) + "\n";
    reports::FolderFiles files{{"summary.json", summary}};
    for (const reports::SequenceRun& run : sequence.runs)
        files.emplace_back(run.configuration.file + ".csv", reports::sequence_csv(sequence, run));
    files.emplace_back("index.html", reports::study_html(reports::sequence_page(
                                         sequence, scene.name, command_of(options, scene.camera))));
    reports::write_folder(options.folder, files);
    if (options.json) fmt::print("{}", summary);
}

}  // namespace

void add_sequence_command(CLI::App& app) {
    CLI::App& command =
        *app.add_subcommand("sequence", "Times the probes over an animation in six configurations");
    const auto options = std::make_shared<Options>();
    command.add_option("scene", options->scene, "Built-in name, or .json, .gltf, .glb file")
        ->required();
    command
        .add_option("-o,--output", options->folder,
                    "Folder for index.html, summary.json and a CSV file of each configuration")
        ->required();
    add_common_options(command, options->common);
    command.remove_option(command.get_option("--frame"));
    command.add_option("--frames", options->sequence.frames,
                       "Frames to play, spread evenly over the scene's own (default: 600)");
    command.add_option("--repeats", options->sequence.repeats,
                       "Runs that each frame's times are the mean of (default: 1)");
    command.add_option("--model", options->sequence.model,
                       fmt::format("{} (default: thesis)", fmt::join(ddgi::model_names(), ", ")));
    command.add_flag("--json", options->json, "Print summary.json on stdout too");
    command.callback([options] { run(*options); });
}

}  // namespace plumbline
