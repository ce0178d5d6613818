// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace CLI {
class App;
}

namespace plumbline {

/// The subcommands of this folder.
void add_pathtracer_commands(CLI::App& app);

namespace pathtracer {

void add_render_command(CLI::App& app);
void add_merge_command(CLI::App& app);
void add_prove_command(CLI::App& app);

}  // namespace pathtracer

}  // namespace plumbline
