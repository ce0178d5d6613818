// SPDX-License-Identifier: Apache-2.0
#include "scenes/command_line.h"

#include <fmt/core.h>
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>  // the parser itself, for the whole program

#include "scenes/errors.h"
#include "scenes/number_pair.h"
#include "scenes/progress.h"
#include "scenes/scene_files.h"

namespace plumbline {
namespace {

/// More threads than this is a slip of the finger; oneTBB would try to start them all.
constexpr int most_threads = 1024;
/// Pixels along a side; a layer of a square picture of this size takes 3 GB.
constexpr int largest_side = 16384;

void check_threads(int threads) {
    if (threads < 1 || threads > most_threads) {
        throw UsageError("--threads", fmt::format("{} threads", threads),
                         fmt::format("give 1 to {}", most_threads));
    }
}

void set_size(CommonOptions& options, const std::string& text) {
    const auto size = parsed_pair(text, 'x');
    if (!size || size->x > largest_side || size->y > largest_side) {
        throw UsageError(
            "--size", fmt::format("'{}' is not a size", text),
            fmt::format("give WIDTHxHEIGHT in pixels, such as 480x270, each side 1 to {}",
                        largest_side));
    }
    options.width = size->x;
    options.height = size->y;
}

}  // namespace

int exit_code = 0;

std::shared_ptr<void> CommonOptions::apply() const {
    if (quiet) Progress::silence();
    if (threads == 0) return nullptr;
    return std::make_shared<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                 static_cast<std::size_t>(threads));
}

void add_common_options(CLI::App& command, CommonOptions& options) {
    command.add_option_function<int>(
        "--threads",
        [&options](int threads) {
            check_threads(threads);
            options.threads = threads;
        },
        "Threads to use (default: all cores)");
    command.add_option_function<std::string>(
        "--size", [&options](const std::string& text) { set_size(options, text); },
        "Size of the picture, WIDTHxHEIGHT in pixels (default: the scene's)");
    command.add_option("--frame", options.frame, "Frame of the animation (default: 0)");
    command.add_flag("--quiet", options.quiet, "No progress on stderr");
}

Scene load_scene_for(const std::string& name, const CommonOptions& options) {
    Scene scene = load_scene(name);
    if (options.width && options.height) {
        scene.camera.width = *options.width;
        scene.camera.height = *options.height;
    }
    return scene;
}

int frame_of(const Scene& scene, const CommonOptions& options) {
    const int frame = options.frame.value_or(0);
    if (frame < 0 || frame >= scene.frames) {
        throw UsageError("--frame", fmt::format("'{}' has no frame {}", scene.name, frame),
                         fmt::format("give 0 to {}", scene.frames - 1));
    }
    return frame;
}

}  // namespace plumbline
