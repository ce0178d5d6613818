// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>

#include "scenes/command_line.h"
#include "scenes/commands.h"
#include "scenes/inspection.h"
#include "scenes/json_layout.h"

namespace plumbline {
namespace {

struct Options {
    CommonOptions common;
    std::string scene;
    bool json = false;
};

/// A line an element: its name, or its number if it has none, and the rest of it as JSON.
void print_list(const char* title, const OrderedJson& list, const char* name_key) {
    fmt::print("\n{} ({})\n", title, list.size());
    for (const OrderedJson& element : list) {
        OrderedJson rest = element;
        rest.erase(name_key);
        std::string line;
        for (const auto& [key, value] : rest.items()) {
            if (value == false || value.is_null()) continue;
            line += (line.empty() ? "" : ", ") + key + " " +
                    (value.is_string() ? value.get<std::string>() : value.dump());
        }
        fmt::print("  {:<24} {}\n", element.at(name_key).get<std::string>(), line);
    }
}

void print_reasons(const char* title, const OrderedJson& list) {
    fmt::print("\n{}\n", title);
    for (const OrderedJson& reason : list) {
        fmt::print("  {:<24} {}\n", reason.at("effect").get<std::string>(),
                   reason.at("why").get<std::string>());
    }
}

void print_text(const OrderedJson& scene) {
    fmt::print("{}: {}\n", scene.at("name").get<std::string>(),
               scene.at("description").get<std::string>());
    fmt::print("frame {} of {}, {} triangles, {} spheres\n", scene.at("frame").dump(),
               scene.at("frames").dump(), scene.at("triangles").dump(), scene.at("spheres").dump());
    for (const char* key : {"bounds", "environment", "camera", "probes", "thesis"}) {
        if (!scene.at(key).is_null()) fmt::print("{:<12} {}\n", key, scene.at(key).dump());
    }
    print_list("objects", scene.at("objects"), "name");
    print_list("materials", scene.at("materials"), "name");
    print_list("lights", scene.at("lights"), "name");
    print_reasons("simulated", scene.at("effects"));
    print_reasons("not simulated", scene.at("skipped"));
    for (const OrderedJson& warning : scene.at("warnings")) {
        fmt::print(stderr, "plumbline: warning: {}\n", warning.get<std::string>());
    }
}

void inspect(const Options& options) {
    const Scene scene = load_scene_for(options.scene, options.common);
    const OrderedJson json = inspection(scene, frame_of(scene, options.common));
    if (options.json) {
        fmt::print("{}\n", laid_out(json));
    } else {
        print_text(json);
    }
}

}  // namespace

void add_inspect_command(CLI::App& app) {
    const auto options = std::make_shared<Options>();
    CLI::App& command = *app.add_subcommand(
        "inspect", "Show what a scene holds, what is simulated, what is not, and why");
    command.add_option("scene", options->scene, "Built-in name, or .json, .gltf or .glb")
        ->required();
    command.add_flag("--json", options->json, "As JSON");
    add_common_options(command, options->common);
    command.callback([options] { inspect(*options); });
}

}  // namespace plumbline
