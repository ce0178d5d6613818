// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "compare/commands.h"
#include "compare/comparison_json.h"
#include "compare/comparison_text.h"
#include "compare/error_maps.h"
#include "compare/thresholds.h"
#include "scenes/command_line.h"

namespace plumbline::compare {

namespace {

struct CompareOptions {
    CommonOptions common;
    std::string reference;
    std::string test;
    std::string layer;
    FlipOptions flip;
    std::string folder;
    bool json = false;
    std::vector<std::string> fail_above;
};

void warn_of_non_finite(const Comparison& comparison) {
    if (comparison.non_finite == 0) return;
    fmt::print(
        stderr, "plumbline: {} values are not finite, the first at pixel ({}, {}); left out\n",
        comparison.non_finite, comparison.first_non_finite->x, comparison.first_non_finite->y);
}

void run(const CompareOptions& options) {
    const auto threads = options.common.apply();
    std::vector<Threshold> thresholds;
    for (const std::string& text : options.fail_above) thresholds.push_back(parse_threshold(text));

    const Image reference = read_image(options.reference);
    const Image test = read_image(options.test);
    const Comparison comparison = compare_images(reference, test, options.layer, options.flip);
    warn_of_non_finite(comparison);
    if (!options.folder.empty()) write_error_maps(options.folder, reference, test, comparison);
    if (options.json)
        fmt::print("{}\n", to_json(comparison).dump(2));
    else
        fmt::print("{}", to_text(comparison));

    for (const std::string& line : exceeded(thresholds, comparison.metrics)) {
        fmt::print(stderr, "plumbline: {}\n", line);
        exit_code = 1;
    }
}

}  // namespace

void add_compare_command(CLI::App& app) {
    CLI::App& command = *app.add_subcommand(
        "compare", "Error of an image against a reference, noise told from bias");
    const auto options = std::make_shared<CompareOptions>();
    add_common_options(command, options->common);
    command.add_option("reference", options->reference, "The image taken as true")->required();
    command.add_option("test", options->test, "The image to judge")->required();
    command.add_option("--layer", options->layer, "Layer to compare (default: radiance)");
    command.add_option("-o,--output", options->folder, "Folder for error maps, EXR and PNG");
    command.add_flag("--json", options->json, "Figures as JSON on stdout");
    command
        .add_option("--fail-above", options->fail_above,
                    "METRIC=VALUE: exit with 1 if the metric is above the value")
        ->allow_extra_args(false);
    command
        .add_option("--pixels-per-degree", options->flip.pixels_per_degree,
                    "How large FLIP's viewer sees the picture (default: 67.02)")
        ->check(CLI::Range(1., 1000.));
    command.add_option("--start-exposure", options->flip.start_exposure,
                       "First exposure of HDR-FLIP, stops (default: from the reference)");
    command.add_option("--stop-exposure", options->flip.stop_exposure,
                       "Last exposure of HDR-FLIP, stops (default: from the reference)");
    command.callback([options] { run(*options); });
}

}  // namespace plumbline::compare
