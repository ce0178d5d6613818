// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "reports/ablation_page.h"
#include "reports/commands.h"
#include "reports/output_folder.h"
#include "reports/truth.h"
#include "reports/words.h"
#include "scenes/command_line.h"
#include "scenes/errors.h"
#include "scenes/output_path.h"

namespace plumbline {

namespace {

/// Of a picture without --size, at 16:9.
constexpr double default_pixels = 480. * 270.;
constexpr double quick_pixels = 160. * 90.;
constexpr int default_spp = 256;
constexpr int quick_spp = 64;

struct Options {
    CommonOptions common;
    std::vector<std::string> scenes;
    std::vector<std::string> references;
    std::vector<std::string> only;
    std::filesystem::path folder;
    bool quick = false;
    bool json = false;
};

void check(const Options& options) {
    check_output_folder(options.folder);
    if (!options.references.empty() && options.references.size() != options.scenes.size())
        throw UsageError(
            "--reference",
            fmt::format("{} files for {} scenes", options.references.size(), options.scenes.size()),
            "give one for each scene, in the same order, or none");
}

reports::TruthSource truth_source(std::size_t index, const Options& options) {
    return {options.references.empty() ? "" : options.references[index],
            options.quick ? quick_pixels : default_pixels, options.quick ? quick_spp : default_spp};
}

std::string command_of(const Options& options) {
    std::string command = "plumbline ablation";
    for (const std::string& scene : options.scenes) command += " " + reports::shell_word(scene);
    if (options.common.width)
        command += fmt::format(" --size {}x{}", *options.common.width, *options.common.height);
    if (options.common.frame) command += fmt::format(" --frame {}", *options.common.frame);
    for (const std::string& file : options.references)
        command += " --reference " + reports::shell_word(file);
    if (!options.only.empty()) command += fmt::format(" --only {}", fmt::join(options.only, ","));
    if (options.quick) command += " --quick";
    return command + " -o " + reports::shell_word(options.folder.string());
}

void run(const Options& options) {
    const auto threads = options.common.apply();
    check(options);
    const auto cases =
        options.only.empty() ? reports::ablation_cases() : reports::ablation_cases(options.only);
    std::vector<reports::AblationScene> measured;
    for (std::size_t i = 0; i < options.scenes.size(); ++i) {
        Scene scene = load_scene_for(options.scenes[i], options.common);
        const int frame =
            options.common.frame ? frame_of(scene, options.common) : scene.report_frame;
        const Image truth =
            reports::truth_of(scene, frame, truth_source(i, options), options.common);
        measured.push_back(reports::measure_ablation(scene, frame, truth, cases));
    }
    const std::string results = reports::ablation_json(measured).dump(2) + "\n";
    reports::write_folder(options.folder,
                          {{"ablation.json", results},
                           {"ablation.csv", reports::ablation_csv(measured)},
                           {"index.html", reports::study_html(reports::ablation_page(
                                              measured, command_of(options)))}});
    if (options.json) fmt::print("{}", results);
}

}  // namespace

void add_ablation_command(CLI::App& app) {
    CLI::App& command = *app.add_subcommand(
        "ablation", "Measures what each step and choice of the probes buys, and what it costs");
    const auto options = std::make_shared<Options>();
    command.add_option("scenes", options->scenes, "Built-in names or scene files")->required();
    command
        .add_option("-o,--output", options->folder,
                    "Folder for index.html, ablation.csv and ablation.json")
        ->required();
    add_common_options(command, options->common);
    command
        .add_option("--reference", options->references,
                    "EXR with the truth of a scene, one for each in order (default: path-traced)")
        ->allow_extra_args(false);
    command
        .add_option("--only", options->only,
                    "Names of the cases to measure, comma-separated, as ablation.csv has them "
                    "(default: all)")
        ->delimiter(',');
    command.add_flag("--quick", options->quick, "Smaller pictures and a noisier truth");
    command.add_flag("--json", options->json, "Print ablation.json on stdout too");
    command.callback([options] { run(*options); });
}

}  // namespace plumbline
