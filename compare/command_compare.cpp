// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "compare/commands.h"
#include "compare/comparison_json.h"
#include "compare/comparison_text.h"
#include "compare/error_maps.h"
#include "compare/resample.h"
#include "compare/sequence.h"
#include "compare/thresholds.h"
#include "scenes/command_line.h"
#include "scenes/errors.h"
#include "scenes/option_values.h"
#include "scenes/output_path.h"
#include "scenes/progress.h"
#include "scenes/whole_file.h"

namespace plumbline::compare {

namespace {

struct CompareOptions {
    CommonOptions common;
    std::string reference;
    std::string test;
    std::string layer;
    std::string mask, half, reference_half;
    bool resample = false;
    FlipOptions flip;
    std::filesystem::path folder;
    bool json = false;
    std::vector<std::string> fail_above;
};

/// An image and what a reader should know of how it was read.
struct Input {
    Image image;
    std::vector<std::string> notes;
};

Input read_input(const std::filesystem::path& path, const CompareOptions& options,
                 const Image* reference) {
    Input input{read_image(path), {}};
    Image& image = input.image;
    for (const auto& [key, says] : {std::pair("plumbline:decoded", "values decoded "),
                                    std::pair("plumbline:left_out", "of another size, left out: ")})
        if (image.metadata.contains(key))
            input.notes.push_back(path.string() + ": " + says + image.metadata.at(key));
    if (!options.resample || !reference) return input;
    if (image.width() == reference->width() && image.height() == reference->height()) return input;
    input.notes.push_back(fmt::format(
        "{}: resampled from {}x{} to {}x{} by a triangle filter; its variances no longer hold",
        path.string(), image.width(), image.height(), reference->width(), reference->height()));
    image = resampled(image, reference->width(), reference->height());
    return input;
}

/// Reads and compares one pair; the maps go to `maps`, if it is a folder.
Comparison compare_files(const FrameFiles& files, const CompareOptions& options,
                         const std::filesystem::path& maps, std::vector<std::string>& notes) {
    const auto read = [&](const std::filesystem::path& path, const Image* reference) {
        Input input = read_input(path, options, reference);
        notes.insert(notes.end(), input.notes.begin(), input.notes.end());
        return std::move(input.image);
    };
    const Image reference = read(files.reference, nullptr);
    const Image test = read(files.test, &reference);
    std::optional<Image> mask, half, reference_half;
    if (!options.mask.empty()) mask = read(options.mask, &reference);
    if (!options.half.empty()) half = read(options.half, &reference);
    if (!options.reference_half.empty()) reference_half = read(options.reference_half, &reference);
    const auto pointer = [](const std::optional<Image>& image) {
        return image ? &*image : nullptr;
    };
    Comparison comparison =
        compare_images(reference, test, options.layer,
                       {options.flip, pointer(mask), {pointer(reference_half), pointer(half)}});
    if (comparison.non_finite > 0)
        notes.push_back(fmt::format(
            "{} values are not finite, the first at pixel ({}, {}); left out",
            comparison.non_finite, comparison.first_non_finite->x, comparison.first_non_finite->y));
    if (!maps.empty()) write_error_maps(maps, reference, test, comparison);
    return comparison;
}

void fail_if_above(const std::vector<Threshold>& thresholds, const Metrics& metrics,
                   const std::string& where) {
    for (const std::string& line : exceeded(thresholds, metrics)) {
        fmt::print(stderr, "plumbline: {}{}\n", where, line);
        exit_code = 1;
    }
}

void print_notes(const std::vector<std::string>& notes, const std::string& where = "") {
    for (const std::string& note : notes) fmt::print(stderr, "plumbline: {}{}\n", where, note);
}

void run_pair(const CompareOptions& options, const std::vector<Threshold>& thresholds) {
    std::vector<std::string> notes;
    const Comparison comparison =
        compare_files({0, options.reference, options.test}, options, options.folder, notes);
    print_notes(notes);
    if (options.json) {
        auto json = to_json(comparison);
        json["notes"] = notes;
        fmt::print("{}\n", json.dump(2));
    } else {
        fmt::print("{}", to_text(comparison));
    }
    fail_if_above(thresholds, comparison.metrics, "");
}

void run_sequence(const CompareOptions& options, const std::vector<Threshold>& thresholds) {
    for (const auto& [name, value] :
         {std::pair("--half", options.half), std::pair("--reference-half", options.reference_half)})
        if (!value.empty())
            throw UsageError(name, "is of one image, but these are sequences",
                             "compare the frames one by one");
    const std::vector<FrameFiles> frames = sequence_frames(options.reference, options.test);
    std::vector<FrameError> errors;
    {
        Progress progress("compare", frames.size());
        for (const FrameFiles& files : frames) {
            const std::string number = fmt::format("{:04}", files.frame);
            std::vector<std::string> notes;
            const Comparison comparison = compare_files(
                files, options, options.folder.empty() ? "" : options.folder / number, notes);
            print_notes(notes, "frame " + number + ": ");
            errors.push_back(
                {files.frame, comparison.metrics, comparison.noise, comparison.non_finite});
            progress.advance();
        }
    }
    if (!options.folder.empty()) {
        write_text(options.folder / "errors.csv", sequence_csv(errors));
        write_text(options.folder / "errors.json", sequence_json(errors).dump(2) + "\n");
    }
    if (options.json)
        fmt::print("{}\n", sequence_json(errors).dump(2));
    else
        fmt::print("{}", sequence_text(errors));
    for (const FrameError& error : errors)
        fail_if_above(thresholds, error.metrics, fmt::format("frame {}: ", error.frame));
}

void run(const CompareOptions& options) {
    const auto threads = options.common.apply();
    if (!options.folder.empty()) check_output_folder(options.folder);
    std::vector<Threshold> thresholds;
    for (const std::string& text : options.fail_above) thresholds.push_back(parse_threshold(text));
    if (is_sequence(options.reference) || is_sequence(options.test))
        run_sequence(options, thresholds);
    else
        run_pair(options, thresholds);
}

void add_flip_options(CLI::App& command, FlipOptions& flip) {
    command
        .add_option("--ppd,--pixels-per-degree", flip.pixels_per_degree,
                    "How large FLIP's viewer sees the picture (default: 67.02)")
        ->check(from_to(1., 1000.));
    command.add_option("--start-exposure", flip.start_exposure,
                       "First exposure of HDR-FLIP, stops (default: from the reference)");
    command.add_option("--stop-exposure", flip.stop_exposure,
                       "Last exposure of HDR-FLIP, stops (default: from the reference)");
    command.add_option_function<std::string>(
        "--tone-mapper", [&flip](const std::string& name) { flip.tone_mapper = tone_mapper(name); },
        "Of HDR-FLIP: aces, hable or reinhard (default: aces)");
}

}  // namespace

void add_compare_command(CLI::App& app) {
    CLI::App& command = *app.add_subcommand(
        "compare", "Error of an image, or a sequence, against a reference, noise told from bias");
    const auto options = std::make_shared<CompareOptions>();
    add_common_options(command, options->common);
    command
        .add_option("reference", options->reference,
                    "The image taken as true; NAME.####.exr: a sequence")
        ->required();
    command.add_option("test", options->test, "The image, or sequence, to judge")->required();
    command.add_option("--layer", options->layer, "Layer to compare (default: radiance)");
    command.add_option("--mask", options->mask, "Image: pixels count where it is at least 0.5");
    command.add_option("--half", options->half,
                       "The test rendered again with independent noise, which tells its noise");
    command.add_option("--reference-half", options->reference_half, "The same for the reference");
    command.add_flag("--resample", options->resample,
                     "Resample images of another size than the reference instead of refusing them");
    command.add_option("-o,--output", options->folder,
                       "Folder for error maps, EXR and PNG; of a sequence also errors.csv, .json");
    command.add_flag("--json", options->json, "Figures as JSON on stdout");
    command
        .add_option("--fail-above", options->fail_above,
                    "METRIC=VALUE: exit with 1 if the metric is above the value")
        ->allow_extra_args(false);
    add_flip_options(command, options->flip);
    command.callback([options] { run(*options); });
}

}  // namespace plumbline::compare
