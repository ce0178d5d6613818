// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <memory>

#include "compare/fit_report.h"
#include "ddgi/render.h"
#include "pathtracer/render.h"
#include "reports/commands.h"
#include "scenes/command_line.h"
#include "scenes/errors.h"
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
    std::filesystem::path folder;
    bool json = false;
};

/// A scene, and where its truth comes from.
struct Subject {
    Scene scene;
    int frame;
    Image truth;
};

Image rendered_truth(Scene& scene, int frame, const FitOptions& options) {
    if (!options.common.width) {
        const double shrink =
            std::sqrt(default_pixels / (double(scene.camera.width) * scene.camera.height));
        scene.camera.width = std::max(1, int(std::lround(scene.camera.width * shrink)));
        scene.camera.height = std::max(1, int(std::lround(scene.camera.height * shrink)));
    }
    pathtracer::RenderOptions render;
    render.spp = options.spp;
    return pathtracer::render(scene, frame, render).image;
}

Subject subject_of(std::size_t i, const FitOptions& options) {
    Scene scene = load_scene_for(options.scenes[i], options.common);
    const int frame = options.common.frame ? frame_of(scene, options.common) : scene.report_frame;
    Image truth = options.references.empty() ? rendered_truth(scene, frame, options)
                                             : read_image(options.references[i]);
    scene.camera.width = truth.width();
    scene.camera.height = truth.height();
    return {std::move(scene), frame, std::move(truth)};
}

/// The truths, the model's pictures with the fitted constants, and the figures.
void write_results(const FitOptions& options, const std::vector<Subject>& subjects,
                   const compare::FitResult& result) {
    ddgi::DdgiOptions fitted;
    fitted.model = result.model;
    for (const compare::FittedConstant& constant : result.constants)
        fitted.set[constant.name] = constant.value;
    for (const Subject& subject : subjects) {
        write_exr(options.folder / (subject.scene.name + "-truth.exr"), subject.truth);
        write_exr(options.folder / (subject.scene.name + "-fitted.exr"),
                  ddgi::render(subject.scene, subject.frame, fitted).image);
    }
    write_text(options.folder / "fit.json", compare::to_json(result).dump(2) + "\n");
}

void run(const FitOptions& options) {
    const auto threads = options.common.apply();
    if (!options.references.empty() && options.references.size() != options.scenes.size())
        throw UsageError(
            "--reference",
            fmt::format("{} files for {} scenes", options.references.size(), options.scenes.size()),
            "give one for each scene, in the same order, or none");
    std::vector<Subject> subjects;
    for (std::size_t i = 0; i < options.scenes.size(); ++i)
        subjects.push_back(subject_of(i, options));
    std::vector<compare::FitCase> cases;
    for (const Subject& subject : subjects)
        cases.push_back({&subject.scene, subject.frame, &subject.truth});
    const compare::FitResult result = compare::fit(cases);
    if (!options.folder.empty()) write_results(options, subjects, result);
    if (options.json)
        fmt::print("{}\n", compare::to_json(result).dump(2));
    else
        fmt::print("{}", compare::to_text(result));
}

}  // namespace

void add_fit_command(CLI::App& app) {
    CLI::App& command = *app.add_subcommand(
        "fit", "Constants of the thesis's model that match the truth best, and how well");
    const auto options = std::make_shared<FitOptions>();
    command.add_option("scenes", options->scenes, "Built-in names or scene files")->required();
    add_common_options(command, options->common);
    command
        .add_option("--reference", options->references,
                    "EXR with the truth of a scene, one for each in order (default: path-traced)")
        ->allow_extra_args(false);
    command.add_option("--spp", options->spp, "Samples a pixel of a truth (default: 128)")
        ->check(CLI::Range(2, 1 << 24));
    command.add_option("-o,--output", options->folder, "Folder for fit.json and the pictures");
    command.add_flag("--json", options->json, "Figures as JSON on stdout");
    command.callback([options] { run(*options); });
}

}  // namespace plumbline
