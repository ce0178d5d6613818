// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/App.hpp>  // not CLI.hpp: it emits the whole parser into each file that includes it
#include <memory>
#include <optional>
#include <string>

#include "scenes/scene.h"

namespace plumbline {

/// The options that every subcommand takes, and the scene if it takes one.
struct CommonOptions {
    int threads = 0;  ///< 0: all cores
    std::optional<int> width, height;
    std::optional<int> frame;
    bool quiet = false;

    /// Limits oneTBB to `threads` (kept alive by the returned handle) and silences progress.
    std::shared_ptr<void> apply() const;
};

/// Adds --threads, --size, --frame and --quiet. `options` must outlive the parse.
void add_common_options(CLI::App& command, CommonOptions& options);

/// Loads a built-in scene or a file, with --size taken into its camera.
/// Throws SceneError or UsageError.
Scene load_scene_for(const std::string& scene, const CommonOptions& options);

/// --frame, or frame 0. Throws UsageError if the scene has no such frame.
int frame_of(const Scene& scene, const CommonOptions& options);

/// A mistake on the command line in one line: the subcommand and option, what is wrong, and what
/// would be right. `app` is the program, which has parsed as far as it could.
std::string usage_line(const CLI::App& app, const CLI::ParseError& error);

/// How a subcommand ends when nothing was thrown: 0 done, 1 a check that was asked for failed.
/// The callback of each subcommand sets it; plumbline.cpp returns it.
extern int exit_code;

}  // namespace plumbline
