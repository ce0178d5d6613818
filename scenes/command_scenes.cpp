// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>

#include "scenes/command_line.h"
#include "scenes/commands.h"
#include "scenes/json_layout.h"
#include "scenes/scene_files.h"

namespace plumbline {
namespace {

struct Options {
    CommonOptions common;
    bool json = false;
};

void list_scenes(const Options& options) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const std::string& name : builtin_scene_names()) {
        const Scene scene = load_scene(name);
        list.push_back(
            {{"name", scene.name}, {"description", scene.description}, {"frames", scene.frames}});
        if (!options.json) fmt::print("{:<20} {}\n", scene.name, scene.description);
    }
    if (options.json) fmt::print("{}\n", laid_out(list));
}

}  // namespace

void add_scenes_command(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    CLI::App& command = *app.add_subcommand("scenes", "List the built-in scenes");
    add_common_options(command, options->common);
    command.add_flag("--json", options->json, "As JSON");
    command.callback([options] { list_scenes(*options); });
}

}  // namespace plumbline
