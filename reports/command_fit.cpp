// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <set>

#include "compare/fit_report.h"
#include "compare/layer_fit.h"
#include "ddgi/render.h"
#include "ddgi/thesis_setup.h"
#include "pathtracer/render.h"
#include "reports/commands.h"
#include "reports/truth.h"
#include "scenes/command_line.h"
#include "scenes/errors.h"
#include "scenes/output_path.h"
#include "scenes/progress.h"
#include "scenes/whole_file.h"

namespace plumbline {

namespace {

/// Pixels of a truth rendered without --size, in the camera's own proportions.
constexpr double default_pixels = 480. * 270.;

struct FitOptions {
    CommonOptions common;
    std::vector<std::string> scenes;
    std::vector<std::string> references;
    int spp = 128;
    compare::FitSettings settings;
    std::vector<int> test_frames;
    std::vector<std::string> layers;
    std::string layer;
    std::vector<double> bounds;
    std::filesystem::path folder;
    bool json = false;
};

/// A scene, and where its truth comes from.
struct Subject {
    Scene scene;
    int frame;
    Image truth;

    compare::FitCase fit_case() const { return {&scene, frame, &truth}; }
};

Subject subject_of(std::size_t i, const FitOptions& options) {
    Scene scene = load_scene_for(options.scenes[i], options.common);
    ddgi::check_thesis_grid(scene.name, probe_grid(scene));
    const int frame = options.common.frame ? frame_of(scene, options.common) : scene.report_frame;
    Image truth = reports::truth_of(
        scene, frame,
        {options.references.empty() ? "" : options.references[i], default_pixels, options.spp},
        options.common);
    return {std::move(scene), frame, std::move(truth)};
}

/// The same scenes at the frames that the constants are only tested on.
std::vector<Subject> test_subjects(const std::vector<Subject>& subjects,
                                   const FitOptions& options) {
    std::vector<Subject> tests;
    for (const Subject& subject : subjects)
        for (int frame : options.test_frames) {
            CommonOptions at = options.common;
            at.frame = frame;
            Scene scene = subject.scene;
            pathtracer::RenderOptions render;
            render.spp = options.spp;
            Image truth = pathtracer::render(scene, frame_of(scene, at), render).image;
            tests.push_back({std::move(scene), frame, std::move(truth)});
        }
    return tests;
}

/// One line on a terminal that tells how far the fit is.
void show_step(const compare::Step& step) {
    if (!Progress::visible()) return;
    fmt::print(stderr, "\rfit: round {}, iteration {}, cost {:.6g}, gradient {:.2g}   ", step.round,
               step.iteration, step.cost, step.gradient);
    static_cast<void>(std::fflush(stderr));
}

void print_result(const FitOptions& options, const compare::FitResult& result) {
    if (Progress::visible()) fmt::print(stderr, "\n");
    if (!options.folder.empty())
        write_text(options.folder / "fit.json", compare::to_json(result).dump(2) + "\n");
    if (options.json)
        fmt::print("{}\n", compare::to_json(result).dump(2));
    else
        fmt::print("{}", compare::to_text(result));
}

/// The truths and the model's pictures with the fitted constants.
void write_pictures(const FitOptions& options, const std::vector<Subject>& subjects,
                    const compare::FitResult& result) {
    for (std::size_t i = 0; i < subjects.size(); ++i) {
        const Subject& subject = subjects[i];
        ddgi::DdgiOptions fitted;
        fitted.model = result.model;
        fitted.set = result.case_constants[i];
        write_exr(options.folder / (subject.scene.name + "-truth.exr"), subject.truth);
        write_exr(options.folder / (subject.scene.name + "-fitted.exr"),
                  ddgi::render(subject.scene, subject.frame, fitted).image);
    }
}

/// Its pictures are named after the scenes.
void check_names(const std::vector<Subject>& subjects) {
    std::set<std::string> names;
    for (const Subject& subject : subjects)
        if (!names.insert(subject.scene.name).second)
            throw UsageError("fit", fmt::format("two scenes are named '{}'", subject.scene.name),
                             "with -o give each a name of its own");
}

void check_references(const FitOptions& options) {
    if (!options.references.empty() && options.references.size() != options.scenes.size())
        throw UsageError(
            "--reference",
            fmt::format("{} files for {} scenes", options.references.size(), options.scenes.size()),
            "give one for each scene, in the same order, or none");
}

void run_scenes(const FitOptions& options) {
    check_references(options);
    std::vector<Subject> subjects;
    for (std::size_t i = 0; i < options.scenes.size(); ++i)
        subjects.push_back(subject_of(i, options));
    if (!options.folder.empty()) check_names(subjects);
    const std::vector<Subject> tests = test_subjects(subjects, options);
    compare::FitSettings settings = options.settings;
    settings.watch = show_step;
    std::vector<compare::FitCase> cases;
    for (const Subject& subject : subjects) cases.push_back(subject.fit_case());
    for (const Subject& test : tests) settings.tests.push_back(test.fit_case());
    const compare::FitResult result = compare::fit(cases, settings);
    if (!options.folder.empty()) write_pictures(options, subjects, result);
    print_result(options, result);
}

/// "FILE" is its radiance, "FILE:LAYER" a layer of it.
std::pair<std::string, std::string> file_and_layer(const std::string& text) {
    const std::size_t colon = text.rfind(':');
    if (colon == std::string::npos || std::filesystem::exists(text)) return {text, ""};
    return {text.substr(0, colon), text.substr(colon + 1)};
}

void run_layers(const FitOptions& options) {
    if (options.references.size() != 1)
        throw UsageError("--reference", fmt::format("{} files", options.references.size()),
                         "gains of --layers need one reference");
    const Image reference = read_image(options.references[0]);
    std::vector<Image> images;
    for (const std::string& text : options.layers)
        images.push_back(read_image(file_and_layer(text).first));
    std::vector<compare::GainLayer> layers;
    for (std::size_t i = 0; i < images.size(); ++i)
        layers.push_back({options.layers[i], &images[i], file_and_layer(options.layers[i]).second});
    compare::LayerFitSettings settings;
    settings.layer = options.layer;
    settings.loss = options.settings.loss;
    settings.watch = show_step;
    if (!options.bounds.empty()) {
        settings.lower = options.bounds[0];
        settings.upper = options.bounds[1];
    }
    print_result(options, compare::fit_layers(layers, reference, settings));
}

void run(const FitOptions& options) {
    const auto threads = options.common.apply();
    if (options.layers.empty() == options.scenes.empty())
        throw UsageError("fit",
                         options.layers.empty() ? "nothing to fit" : "scenes beside --layers",
                         "name scenes, or image layers with --layers, not both");
    if (!options.folder.empty()) check_output_folder(options.folder);
    if (options.layers.empty())
        run_scenes(options);
    else
        run_layers(options);
}

/// `of_scenes` are the options that mean nothing without scenes.
void add_layer_options(CLI::App& command, FitOptions& options,
                       const std::vector<CLI::Option*>& of_scenes) {
    CLI::Option* layers =
        command
            .add_option(
                "--layers", options.layers,
                "Fit gains of these images, FILE or FILE:LAYER, instead of a scene's constants")
            ->delimiter(',')
            ->allow_extra_args(false);
    for (CLI::Option* option : of_scenes) layers->excludes(option);
    command
        .add_option("--layer", options.layer,
                    "Layer of the reference that --layers add up to (default: radiance)")
        ->needs(layers);
    command
        .add_option("--bounds", options.bounds,
                    "LOW,HIGH of the gains of --layers (default: from 0)")
        ->needs(layers)
        ->delimiter(',')
        ->expected(2);
}

}  // namespace

void add_fit_command(CLI::App& app) {
    CLI::App& command = *app.add_subcommand(
        "fit", "Constants of the thesis's model that match the truth best, and how well");
    const auto options = std::make_shared<FitOptions>();
    command.add_option("scenes", options->scenes, "Built-in names or scene files");
    add_common_options(command, options->common);
    command
        .add_option("--reference", options->references,
                    "EXR with the truth of a scene, one for each in order (default: path-traced)")
        ->allow_extra_args(false);
    CLI::Option* spp =
        command.add_option("--spp", options->spp, "Samples a pixel of a truth (default: 128)")
            ->check(CLI::Range(2, 1 << 24));
    CLI::Option* free =
        command
            .add_option("--free", options->settings.free,
                        "Constants to fit, NAME,NAME (default: all but multiBounceIntensity)")
            ->delimiter(',')
            ->allow_extra_args(false);
    CLI::Option* per_scene =
        command
            .add_option("--per-scene", options->settings.per_scene,
                        "Those of them that each scene has for itself, NAME,NAME (default: none)")
            ->delimiter(',')
            ->allow_extra_args(false);
    command.add_option_function<std::string>(
        "--loss",
        [options](const std::string& name) { options->settings.loss = compare::loss_named(name); },
        "squares, huber or cauchy: what a large residual costs (default: squares)");
    CLI::Option* test_frames =
        command
            .add_option("--test-frames", options->test_frames,
                        "Further frames of each scene, path-traced, to test the constants on, F,F")
            ->delimiter(',')
            ->allow_extra_args(false);
    add_layer_options(command, *options, {spp, free, per_scene, test_frames});
    command.add_option("-o,--output", options->folder, "Folder for fit.json and the pictures");
    command.add_flag("--json", options->json, "Figures as JSON on stdout");
    command.callback([options] { run(*options); });
}

}  // namespace plumbline
