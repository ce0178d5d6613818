// SPDX-License-Identifier: Apache-2.0
#include <fmt/chrono.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <ctime>
#include <filesystem>
#include <memory>

#include "reports/commands.h"
#include "reports/output_folder.h"
#include "reports/page.h"
#include "reports/picture_size.h"
#include "reports/report.h"
#include "reports/results_json.h"
#include "reports/results_markdown.h"
#include "reports/stages.h"
#include "reports/words.h"
#include "scenes/command_line.h"
#include "scenes/errors.h"
#include "scenes/output_path.h"
#include "scenes/scene_files.h"

namespace plumbline {

namespace {

/// Pixels of a picture without --size, in the camera's own proportions: 480 x 270 at 16:9.
constexpr double default_pixels = 480. * 270.;

/// What measure_constants() and all hard cases take, in the unit of Stages.
constexpr double work_of_transfer = 120;
constexpr double work_of_hard_cases = 300;

struct Options {
    CommonOptions common;
    std::vector<std::string> scenes;
    std::filesystem::path folder;
    bool quick = false;
    bool hard_cases = false;
    bool publish = false;
    std::filesystem::path results;  ///< where to publish; empty: in the sources
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
    if (options.hard_cases) command += " --hard-cases";
    if (options.publish) command += " --publish";
    if (!options.results.empty())
        command += " --results " + reports::shell_word(options.results.string());
    return command + " -o " + reports::shell_word(options.folder.string());
}

/// Where the published results go. Throws UsageError where no sources are.
std::filesystem::path published_file(const Options& options) {
    if (!options.results.empty()) return options.results;
    if (!std::filesystem::exists("plumbline.cpp") || !std::filesystem::is_directory("reports"))
        throw UsageError("--publish", "Plumbline's sources are not in this folder",
                         "run it there, or say where with --results FILE.md");
    return std::filesystem::path("reports") / "RESULTS.md";
}

/// What the constants of all scenes that have some have in common.
void measure_constants(reports::Report& report, const std::vector<Subject>& subjects,
                       const reports::Quality& quality, reports::Stages& stages) {
    std::vector<compare::FitCase> cases;
    std::vector<reports::TransferScene> scenes;
    double pixels = quality.transfer_pixels;
    for (std::size_t i = 0; i < subjects.size(); ++i) {
        const auto& [argument, scene, frame] = subjects[i];
        if (!report.scenes[i].fit) continue;
        cases.push_back({&scene, frame, &report.scenes[i].truth.image});
        scenes.push_back({&scene, frame});
        pixels = std::min(pixels, double(scene.camera.width) * scene.camera.height);
    }
    if (cases.empty()) return;
    stages.begin("the constants of one scene on another", work_of_transfer);
    report.transfer = reports::measure_transfer(scenes, pixels, quality.transfer_spp);
    if (cases.size() > 1) report.shared = compare::fit(cases);
}

void run(const Options& options) {
    const std::shared_ptr<void> threads = options.common.apply();
    check_output_folder(options.folder);
    const std::filesystem::path published =
        options.publish ? published_file(options) : std::filesystem::path();
    if (options.publish) check_output_file(published);
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
    reports::Stages stages(work + work_of_transfer + (options.hard_cases ? work_of_hard_cases : 0));
    for (const Subject& subject : subjects)
        report.scenes.push_back(
            reports::measure(subject.argument, subject.scene, subject.frame, quality, stages));
    measure_constants(report, subjects, quality, stages);
    if (options.hard_cases) {
        stages.begin("the hard cases", work_of_hard_cases);
        report.hard_cases = reports::run_cases(reports::hard_cases(), [](const auto&) {});
    }
    const std::string results = reports::results_json(report).dump(2) + "\n";
    const std::string page = reports::page_html(report);
    reports::write_folder(options.folder, {{"results.json", results}, {"index.html", page}});
    if (options.publish)
        reports::write_folder(published.parent_path(),
                              reports::published_files(report, published.filename().string()));
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
    command->add_flag("--quick", options->quick, "Fewer samples: more noise, half the time");
    command->add_flag("--hard-cases", options->hard_cases,
                      "Also run the hard cases of `plumbline stress` and show their table");
    command->add_flag("--publish", options->publish,
                      "Also write the results as Markdown with small pictures");
    command->add_option("--results", options->results,
                        "File for --publish (default: reports/RESULTS.md of the sources)");
    add_common_options(*command, options->common);
    command->callback([options] { run(*options); });
}

}  // namespace plumbline
