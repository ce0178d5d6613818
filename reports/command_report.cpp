// SPDX-License-Identifier: Apache-2.0
#include <fmt/chrono.h>

#include <CLI/CLI.hpp>
#include <ctime>
#include <filesystem>
#include <memory>

#include "reports/commands.h"
#include "reports/output_folder.h"
#include "reports/page.h"
#include "reports/picture_size.h"
#include "reports/report.h"
#include "reports/results_json.h"
#include "reports/stages.h"
#include "reports/words.h"
#include "scenes/command_line.h"
#include "scenes/whole_file.h"

namespace plumbline {

namespace {

/// Pixels of a picture without --size, in the camera's own proportions: 480 x 270 at 16:9.
constexpr double default_pixels = 480. * 270.;

struct Options {
    CommonOptions common;
    std::vector<std::string> scenes;
    std::filesystem::path folder;
    bool quick = false;
};

/// What is measured, and at which frame.
struct Subject {
    std::string argument;
    Scene scene;
    int frame;
};

Subject subject_of(const std::string& argument, const CommonOptions& options) {
    Scene scene = load_scene_for(argument, options);
    reports::set_default_size(scene.camera, options, default_pixels);
    const int frame = options.frame ? frame_of(scene, options) : scene.report_frame;
    return {argument, std::move(scene), frame};
}

std::string command_of(const Options& options) {
    std::string command = "plumbline report";
    for (const std::string& scene : options.scenes) command += " " + reports::shell_word(scene);
    if (options.common.width)
        command += fmt::format(" --size {}x{}", *options.common.width, *options.common.height);
    if (options.common.frame) command += fmt::format(" --frame {}", *options.common.frame);
    if (options.common.threads > 0) command += fmt::format(" --threads {}", options.common.threads);
    if (options.quick) command += " --quick";
    return command + " -o " + reports::shell_word(options.folder.string());
}

void run(const Options& options) {
    const std::shared_ptr<void> threads = options.common.apply();
    reports::check_folder(options.folder);
    const reports::Quality quality = reports::quality_of(options.quick);
    std::vector<Subject> subjects;
    double work = 0;
    for (const std::string& argument : options.scenes) {
        subjects.push_back(subject_of(argument, options.common));
        work += reports::total_work(subjects.back().scene, quality);
    }
    reports::Report report{
        .version = PLUMBLINE_VERSION,
        .date = fmt::format("{:%Y-%m-%d %H:%M} UTC", fmt::gmtime(std::time(nullptr))),
        .command = command_of(options),
        .quality = quality.name,
        .machine = reports::this_machine(),
        .scenes = {}};
    reports::Stages stages(work);
    for (const Subject& subject : subjects)
        report.scenes.push_back(
            reports::measure(subject.argument, subject.scene, subject.frame, quality, stages));
    const std::string results = reports::results_json(report).dump(2) + "\n";
    const std::string page = reports::page_html(report);
    write_text(options.folder / "results.json", results);
    write_text(options.folder / "index.html", page);
}

}  // namespace

void add_report_command(CLI::App& app) {
    CLI::App* command = app.add_subcommand(
        "report",
        "Measures every model against the truth and writes one page that tells the result");
    const auto options = std::make_shared<Options>();
    command->add_option("SCENE", options->scenes, "Built-in scenes or .json, .gltf, .glb files")
        ->required();
    command->add_option("-o,--output", options->folder, "Folder for index.html and results.json")
        ->required();
    command->add_flag("--quick", options->quick, "Fewer samples: more noise, a third of the time");
    add_common_options(*command, options->common);
    command->callback([options] { run(*options); });
}

}  // namespace plumbline
