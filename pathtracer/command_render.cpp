// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <cmath>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>

#include "pathtracer/bounce_limit.h"
#include "pathtracer/checkpoint.h"
#include "pathtracer/commands.h"
#include "pathtracer/interrupts.h"
#include "pathtracer/provenance.h"
#include "pathtracer/render.h"
#include "scenes/command_line.h"
#include "scenes/inspection.h"
#include "scenes/option_values.h"
#include "scenes/output_path.h"

namespace plumbline::pathtracer {
namespace {

struct Arguments {
    CommonOptions common;
    RenderOptions render;
    CheckpointOptions checkpoints;
    std::string scene;
    std::string output;
    bool json = false;
};

void print_json(const Scene& scene, const BounceLimit& limit, const RenderResult& result) {
    nlohmann::ordered_json json;
    const auto& [mean, fewest, most] = result.counts;
    json["spp"] =
        fewest == most ? nlohmann::ordered_json(result.spp) : nlohmann::ordered_json(mean);
    json["fewest_samples"] = fewest;
    json["most_samples"] = most;
    json["seconds"] = result.seconds;
    json["rays"] = result.rays;
    json["rays_per_second"] = double(result.rays) / result.seconds;
    json["relmse_estimate"] = result.relmse_estimate;  // NaN becomes null
    json["non_finite"] = result.non_finite.samples;
    if (const auto& first = result.non_finite.first) {
        json["first_non_finite"] = {{"x", first->x}, {"y", first->y}};
    }
    json["width"] = result.image.width();
    json["height"] = result.image.height();
    json["bounces"] = {
        {"max_bounces", limit.max_bounces ? nlohmann::ordered_json(*limit.max_bounces) : nullptr},
        {"why", limit.why}};
    json["effects"] = effects_json(scene, true);
    json["skipped"] = effects_json(scene, false);
    fmt::print("{}\n", json.dump());
}

void tell(const RenderResult& result, const std::string& output) {
    const auto& [mean, fewest, most] = result.counts;
    const std::string spread = fewest == most ? "" : fmt::format(" ({} to {})", fewest, most);
    const std::string relmse = std::isnan(result.relmse_estimate)
                                   ? "relMSE unknown"
                                   : fmt::format("relMSE about {:.2g}", result.relmse_estimate);
    fmt::print(stderr, "{}: {} samples a pixel{} in {:.2f} s, {:.1f} million rays/s, {}\n", output,
               result.spp, spread, result.seconds, double(result.rays) / result.seconds * 1e-6,
               relmse);
    if (const auto& first = result.non_finite.first) {
        fmt::print(
            stderr,
            "{}: {} samples are not finite, the first at pixel ({}, {}); their pixels show it\n",
            output, result.non_finite.samples, first->x, first->y);
    }
}

void run(Arguments& arguments) {
    check_output_picture(arguments.output);
    const auto limits = arguments.common.apply();
    const Scene scene = load_scene_for(arguments.scene, arguments.common);
    const Interrupts interrupts;
    CheckpointOptions& checkpoints = arguments.checkpoints;
    checkpoints.file = arguments.output + ".checkpoint";
    checkpoints.interrupted = [] { return Interrupts::received() != 0; };
    checkpoints.not_written = [](const std::string& line) {
        fmt::print(stderr, "plumbline: {}; the render goes on\n", line);
    };
    const int frame = frame_of(scene, arguments.common);
    const std::optional<RenderResult> result = render(scene, frame, arguments.render, checkpoints);
    if (!result) {
        fmt::print(stderr, "{}: interrupted; the same command with --resume goes on from {}\n",
                   arguments.output, checkpoints.file.string());
        exit_code = 128 + Interrupts::received();  // as shells report it
        return;
    }
    write_exr(arguments.output, result->image);
    // Only now: a kill before this line costs at most what came after the last checkpoint.
    remove_checkpoint(checkpoints.file);
    tell(*result, arguments.output);
    if (!arguments.json) return;
    print_json(scene, bounce_limit(world_at(scene, frame), effects_of(scene), arguments.render),
               *result);
}

}  // namespace

void add_render_command(CLI::App& app) {
    auto arguments = std::make_shared<Arguments>();
    CLI::App& command = *app.add_subcommand("render", "Path-trace a scene: the ground truth");
    command.add_option("scene", arguments->scene, "Built-in name, or .json, .gltf, .glb file")
        ->required();
    command.add_option("-o,--output", arguments->output, "EXR file to write")->required();
    add_common_options(command, arguments->common);

    RenderOptions& options = arguments->render;
    constexpr int most = 1 << 24;  // sums of so many samples keep every digit
    CLI::Option* spp = command.add_option("--spp", options.spp, "Samples a pixel (default: 64)")
                           ->check(CLI::Range(1, most));
    CLI::Option* target = command
                              .add_option("--target-relmse", options.target_relmse,
                                          "Stop when the estimated relMSE falls to this")
                              ->check(above_zero());
    CLI::Option* time = command.add_option("--time", options.seconds, "Stop after so many seconds")
                            ->check(above_zero());
    target->excludes(spp);
    time->excludes(spp)->excludes(target);
    command
        .add_option("--max-bounces", options.max_bounces,
                    "Indirect bounces; 0: direct light only (default: Russian roulette ends them)")
        ->check(CLI::Range(0, most));
    command.add_option("--seed", options.seed, "Seed of all random numbers (default: 0)")
        ->check(CLI::NonNegativeNumber);
    command.add_option_function<std::string>(
        "--shard",
        [&options](const std::string& text) { options.shard = parsed_shard("--shard", text); },
        "Render part I of N, as I/N; 'merge' joins them");
    command.add_flag("--adaptive", options.adaptive,
                     "More samples where the error falls most, their mean as asked");
    CheckpointOptions& checkpoints = arguments->checkpoints;
    command.add_flag("--resume", checkpoints.resume, "Go on where the same render was interrupted");
    command
        .add_option("--checkpoint-every", checkpoints.every_seconds,
                    "Seconds between checkpoints, OUT.exr.checkpoint (default: 60)")
        ->check(above_zero());
    command.add_flag("--json", arguments->json, "Print figures as JSON on stdout");
    command.callback([arguments, target, time] {
        if (target->count() + time->count() > 0) arguments->render.spp = most;
        run(*arguments);
    });
}

}  // namespace plumbline::pathtracer
