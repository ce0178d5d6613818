// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace CLI {
class App;
}

namespace plumbline {

/// The subcommands of this folder.
void add_scenes_commands(CLI::App& app);

void add_scenes_command(CLI::App& app);
void add_inspect_command(CLI::App& app);
void add_export_command(CLI::App& app);

}  // namespace plumbline
