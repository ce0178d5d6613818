// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace CLI {
class App;
}

namespace plumbline {

/// The subcommands of this folder.
void add_compare_commands(CLI::App& app);

namespace compare {

void add_compare_command(CLI::App& app);
void add_audit_command(CLI::App& app);

}  // namespace compare

}  // namespace plumbline
