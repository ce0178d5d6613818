// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>

#include "ddgi/commands.h"
#include "ddgi/model.h"
#include "ddgi/render.h"
#include "scenes/command_line.h"
#include "scenes/errors.h"
#include "scenes/option_values.h"
#include "scenes/output_path.h"

namespace plumbline::ddgi {
namespace {

struct Arguments {
    CommonOptions common;
    DdgiOptions ddgi;
    std::string scene;
    std::string output;
    std::vector<std::string> set;
    bool gi = true;
    bool no_shift = false;
    bool no_parallax = false;
    bool no_cache = false;
    bool json = false;
};

std::pair<std::string, double> parse_constant(const std::string& text) {
    const std::size_t equals = text.find('=');
    const std::string name = text.substr(0, equals);
    const std::string number = equals == std::string::npos ? "" : text.substr(equals + 1);
    char* end = nullptr;
    const double value = std::strtod(number.c_str(), &end);
    if (name.empty() || number.empty() || *end != '\0') {
        throw UsageError("--set", fmt::format("'{}' is not NAME=VALUE", text),
                         "give for example --set probeBrightness=26.2");
    }
    return {name, value};
}

nlohmann::ordered_json json_of(const DdgiResult& result, const DdgiOptions& options) {
    const FrameFigures& figures = result.figures;
    nlohmann::ordered_json json;
    json["model"] = options.model;
    json["bvh_ms"] = figures.bvh_ms;
    json["place_ms"] = figures.place_ms;
    json["light_ms"] = figures.light_ms;
    json["primary_ms"] = figures.primary_ms;
    for (const TimedStep& step : timed_steps) json["steps_ms"][step.name] = figures.steps.*step.ms;
    json["probes"] = figures.probes;
    json["surfels"] = figures.surfels;
    json["surfels_hit"] = figures.surfels_hit;
    json["surfels_lit"] = figures.surfels_lit;
    json["replaced"] = figures.replaced;
    if (options.budget) {
        json["budget"] = *options.budget;
        json["surfels_waiting"] = figures.surfels_waiting;
        json["oldest_wait"] = figures.oldest_wait;
    }
    json["shadow_rays"] = figures.shadow_rays;
    json["surfel_shadow_rays"] = figures.surfel_shadow_rays;
    json["updates"] = figures.updates;
    json["relative_change"] = figures.relative_change;
    json["converged"] = figures.converged;
    if (result.spectral_radius) json["spectral_radius"] = *result.spectral_radius;
    if (result.critical_multi_bounce)
        json["critical_multiBounceIntensity"] = *result.critical_multi_bounce;
    json["non_finite"] = figures.non_finite;
    json["seconds"] = result.seconds;
    json["constants"] = result.constants;
    json["notes"] = result.notes;
    return json;
}

void run(Arguments& arguments) {
    check_output_picture(arguments.output);
    for (const std::string& text : arguments.set) {
        const auto [constant, is_new] = arguments.ddgi.set.insert(parse_constant(text));
        if (!is_new) throw UsageError("--set", constant->first + " is given twice", "give it once");
    }
    arguments.ddgi.gi = arguments.gi;
    arguments.ddgi.cache = !arguments.no_cache;
    arguments.ddgi.probes.shifted = !arguments.no_shift;
    arguments.ddgi.probes.parallax = !arguments.no_parallax;
    arguments.ddgi.spectral_radius =
        arguments.json || arguments.ddgi.set.contains("multiBounceIntensity");
    const auto limits = arguments.common.apply();
    const Scene scene = load_scene_for(arguments.scene, arguments.common);
    const DdgiResult result = render(scene, frame_of(scene, arguments.common), arguments.ddgi);
    write_exr(arguments.output, result.image);

    const FrameFigures& figures = result.figures;
    for (const std::string& note : result.notes) fmt::print(stderr, "plumbline: {}\n", note);
    fmt::print(stderr,
               "{}: {} probes, {} updates{}, {:.2f} s; at this frame placing {:.0f} ms, lighting "
               "{:.0f} ms, picture {:.0f} ms\n",
               arguments.output, figures.probes, figures.updates,
               figures.converged ? " (converged)" : "", result.seconds, figures.place_ms,
               figures.light_ms, figures.primary_ms);
    if (arguments.json) fmt::print("{}\n", json_of(result, arguments.ddgi).dump());
}

void add_probe_options(CLI::App& command, Arguments& arguments) {
    DdgiOptions& options = arguments.ddgi;
    command.add_option("--model", options.model,
                       fmt::format("How probes are lit and looked up: {} (default: {})",
                                   fmt::join(model_names(), ", "), options.model));
    command.add_option("--surfels", options.surfels,
                       "Rays a probe: 64, 96, 128 or 160 for thesis, any multiple of 8 for the "
                       "others (default: 64)");
    command
        .add_option(
            "--set", arguments.set,
            "NAME=VALUE: a constant of the model thesis under its published name, or a setting of "
            "irradiance, such as published=1; may be repeated. "
            "multiBounceIntensity is 0, no feedback, unless set here")
        ->allow_extra_args(false);
    add_choice(command, "--gi", arguments.gi, {{"on", true}, {"off", false}},
               "off: direct light only, no probes (default: on)");
    command.add_flag("--no-cache", arguments.no_cache, "Place every surfel afresh each frame");
    command.add_option("--budget", options.budget,
                       "Surfels that an update re-places or lights again at most, those that wait "
                       "longest and changed most first (default: all)");
    command.add_option("--share", options.share,
                       "Width of cells, in spacings, in each of which light is measured once for "
                       "all rays of all probes that end there (default: 0, at each ray's end)");
    command.add_option("--shadow-rays", options.shadow_rays,
                       "Shadow rays a pixel sample and light: the more, the smoother the soft "
                       "shadows of lights with a radius (default: 1)");
    command.add_option("--updates", options.updates,
                       "Probe updates at the last frame (default: until converged)");
    command.add_option("--spacing", options.spacing,
                       "Distance between probes, over the same extent (default: the scene's)");
}

/// The choices of the model conserving.
void add_model_options(CLI::App& command, Arguments& arguments) {
    ProbeOptions& options = arguments.ddgi.probes;
    add_choice(
        command, "--storage", options.storage, storage_names,
        "What a probe of conserving keeps: the radiance of all its rays; its mean over 8 octants "
        "or 32 or 128 cells of equal solid angle; spherical harmonics of order 2 or 3; or "
        "irradiances on an octahedral map: rays, octants, equal32, equal128, sh2, sh3, "
        "octahedral (default: rays)");
    add_choice(
        command, "--weights", options.weights, weights_names,
        "How conserving tempers the trilinear weights of probes: none, backface (those behind "
        "a surface fade), visibility (those that a point does not see do not count), moments (the "
        "same, bounded by the moments of their distances) (default: visibility)");
    command.add_option("--normal-bias", options.normal_bias,
                       "How far off itself along its normal conserving looks a point up, in "
                       "spacings (default: 0)");
    command.add_flag("--skip-inside", options.skip_inside,
                     "Probes of conserving a quarter or more of whose rays meet backs of surfaces "
                     "do not count: they stand in something");
    add_choice(
        command, "--feedback", options.feedback, feedback_names,
        "What surfels of conserving take the probes' light from: maps of irradiance made once "
        "an update, or rays, as pixels do: slower (default: maps)");
    command.add_flag(
        "--no-shift", arguments.no_shift,
        "All probes have the same ray pattern, not one shifted for each; not for thesis");
    command.add_flag("--no-parallax", arguments.no_parallax,
                     "Pixels take rays' ends to be as far from them as from the probe");
    command.add_option("--edge-samples", arguments.ddgi.edge_samples,
                       "Samples of a pixel on an edge: 4, as elsewhere, or 16 (default: 4 for "
                       "thesis, 16 for the others)");
}

}  // namespace

void add_ddgi_command(CLI::App& app) {
    auto arguments = std::make_shared<Arguments>();
    CLI::App& command = *app.add_subcommand("ddgi", "Light a scene with probes");
    command.add_option("scene", arguments->scene, "Built-in name, or .json, .gltf, .glb file")
        ->required();
    command.add_option("-o,--output", arguments->output, "EXR file to write")->required();
    add_common_options(command, arguments->common);
    add_probe_options(command, *arguments);
    add_model_options(command, *arguments);
    command.add_flag("--json", arguments->json, "Print the last frame's figures on stdout");
    command.callback([arguments] { run(*arguments); });
}

}  // namespace plumbline::ddgi
