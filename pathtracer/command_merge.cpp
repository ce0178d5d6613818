// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <memory>

#include "pathtracer/commands.h"
#include "pathtracer/merge.h"
#include "scenes/command_line.h"
#include "scenes/output_path.h"

namespace plumbline::pathtracer {

void add_merge_command(CLI::App& app) {
    struct Arguments {
        CommonOptions common;
        std::vector<std::filesystem::path> shards;
        std::string output;
    };
    auto arguments = std::make_shared<Arguments>();
    CLI::App& command = *app.add_subcommand("merge", "Join the shards of a render, in any order");
    command.add_option("shards", arguments->shards, "EXR files of 'render --shard I/N'")
        ->required();
    command.add_option("-o,--output", arguments->output, "EXR file to write")->required();
    add_common_options(command, arguments->common);
    for (const char* chosen_by_the_shards : {"--size", "--frame"})
        command.remove_option(command.get_option(chosen_by_the_shards));
    command.callback([arguments] {
        const auto threads = arguments->common.apply();
        check_output_picture(arguments->output);
        const Image image = merge(arguments->shards);
        write_exr(arguments->output, image);
        fmt::print(stderr, "{}: {} shards, {} samples a pixel, {} s in all\n", arguments->output,
                   arguments->shards.size(), image.metadata.at("plumbline:spp"),
                   image.metadata.at("plumbline:seconds"));
    });
}

}  // namespace plumbline::pathtracer
