// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace CLI {
class App;
}

namespace plumbline {

/// The subcommands of this folder.
void add_ddgi_commands(CLI::App& app);

namespace ddgi {

void add_ddgi_command(CLI::App& app);

}  // namespace ddgi

}  // namespace plumbline
