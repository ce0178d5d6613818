// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "compare/commands.h"
#include "compare/energy_audit.h"
#include "scenes/command_line.h"

namespace plumbline::compare {

namespace {

struct AuditOptions {
    CommonOptions common;
    std::string scene;
    std::vector<std::string> models{"thesis", "conserving"};
    int bounces = 4;
    int points = 10000;
    bool json = false;
};

void run(const AuditOptions& options) {
    const auto threads = options.common.apply();
    const Scene scene = load_scene_for(options.scene, options.common);
    const int frame = options.common.frame ? frame_of(scene, options.common) : scene.report_frame;
    auto json = nlohmann::ordered_json::array();
    std::string text;
    for (const std::string& model : options.models) {
        ddgi::DdgiOptions ddgi;
        ddgi.model = model;
        const EnergyAudit audit = energy_audit(scene, frame, ddgi, options.bounces, options.points);
        json.push_back(to_json(audit));
        text += (text.empty() ? "" : "\n") + to_text(audit);
    }
    if (options.json)
        fmt::print("{}\n", json.dump(2));
    else
        fmt::print("{}", text);
}

}  // namespace

void add_audit_command(CLI::App& app) {
    CLI::App& command = *app.add_subcommand(
        "audit",
        "Flux that a probe model takes in, absorbs, and invents or loses, bounce by bounce");
    const auto options = std::make_shared<AuditOptions>();
    command.add_option("scene", options->scene, "Built-in name or scene file")->required();
    add_common_options(command, options->common);
    command.add_option("--model", options->models, "NAME,NAME (default: thesis,conserving)")
        ->delimiter(',')
        ->allow_extra_args(false);
    command.add_option("--bounces", options->bounces, "Indirect bounces to follow (default: 4)")
        ->check(CLI::Range(1, 64));
    command.add_option("--points", options->points, "Points on surfaces (default: 10000)")
        ->check(CLI::Range(100, 10'000'000));
    command.add_flag("--json", options->json, "Figures as JSON on stdout");
    command.callback([options] { run(*options); });
}

}  // namespace plumbline::compare
