// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>

#include "scenes/command_line.h"
#include "scenes/commands.h"
#include "scenes/output_path.h"
#include "scenes/scene_files.h"

namespace plumbline {
namespace {

struct Options {
    CommonOptions common;
    std::string scene;
    std::string output;
};

void export_scene(const Options& options) {
    check_output_file(options.output);
    const Scene scene = load_scene_for(options.scene, options.common);
    for (const std::string& line : scene.not_simulated) {
        fmt::print(stderr, "plumbline: left out: {}\n", line);
    }
    save_scene(scene, options.output);
}

}  // namespace

void add_export_command(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    CLI::App& command = *app.add_subcommand("export", "Write a scene as glTF 2.0 or JSON");
    command.add_option("scene", options->scene, "Built-in name, or .json, .gltf or .glb")
        ->required();
    command.add_option("-o,--output", options->output, "NAME.gltf (and NAME.bin) or NAME.json")
        ->required();
    add_common_options(command, options->common);
    command.callback([options] { export_scene(*options); });
}

}  // namespace plumbline
