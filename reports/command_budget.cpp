// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "ddgi/model.h"
#include "reports/budget_page.h"
#include "reports/commands.h"
#include "reports/output_folder.h"
#include "reports/picture_size.h"
#include "reports/words.h"
#include "scenes/command_line.h"
#include "scenes/output_path.h"

namespace plumbline {

namespace {

/// Of a picture without --size.
constexpr double default_pixels = 160. * 90.;

struct Options {
    CommonOptions common;
    std::string scene;
    std::filesystem::path folder;
    reports::BudgetOptions budget;
    bool json = false;
};

std::string command_of(const Options& options, const Camera& camera) {
    std::string command =
        fmt::format("plumbline budget {} --model {} --size {}x{} --spp {} --truths {}",
                    reports::shell_word(options.scene), options.budget.model, camera.width,
                    camera.height, options.budget.truth_spp, options.budget.truths);
    if (!options.budget.budgets.empty())
        command += fmt::format(" --budgets {}", fmt::join(options.budget.budgets, ","));
    return command + " -o " + reports::shell_word(options.folder.string());
}

void run(const Options& options) {
    const auto threads = options.common.apply();
    check_output_folder(options.folder);
    Scene scene = load_scene_for(options.scene, options.common);
    reports::set_default_size(scene.camera, options.common, default_pixels);
    const reports::BudgetStudy study = reports::measure_budget(scene, options.budget);
    const std::string summary = reports::budget_json(study).dump(2) + "\n";
    reports::write_folder(
        options.folder,
        {{"summary.json", summary},
         {"budget.csv", reports::budget_csv(study)},
         {"index.html", reports::study_html(reports::budget_page(
                            study, scene.name, command_of(options, scene.camera)))}});
    if (options.json) fmt::print("{}", summary);
}

}  // namespace

void add_budget_command(CLI::App& app) {
    CLI::App& command = *app.add_subcommand(
        "budget", "Measures error and cost over an animation whose work is spread over frames");
    const auto options = std::make_shared<Options>();
    command.add_option("scene", options->scene, "Built-in name, or .json, .gltf, .glb file")
        ->required();
    command
        .add_option("-o,--output", options->folder,
                    "Folder for index.html, budget.csv and summary.json")
        ->required();
    add_common_options(command, options->common);
    command.remove_option(command.get_option("--frame"));
    command.add_option("--model", options->budget.model,
                       fmt::format("{} (default: {})", fmt::join(ddgi::model_names(), ", "),
                                   options->budget.model));
    command
        .add_option("--budgets", options->budget.budgets,
                    "Surfels a frame, comma-separated (default: 0.3, 1 and 3 % of all)")
        ->delimiter(',');
    command.add_option("--spp", options->budget.truth_spp,
                       "Samples a pixel of each truth, 32 or more (default: 128)");
    command.add_option("--truths", options->budget.truths,
                       "Frames held against a truth of their own (default: 16)");
    command.add_flag("--json", options->json, "Print summary.json on stdout too");
    command.callback([options] { run(*options); });
}

}  // namespace plumbline
