// SPDX-License-Identifier: Apache-2.0
#include "scenes/commands.h"

#include "scenes/command_line.h"

namespace plumbline {

void add_scenes_commands(CLI::App& app) {
    add_scenes_command(app);
    add_inspect_command(app);
    add_export_command(app);
}

}  // namespace plumbline
