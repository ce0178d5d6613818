// SPDX-License-Identifier: Apache-2.0
#include "compare/commands.h"

namespace plumbline {

void add_compare_commands(CLI::App& app) {
    compare::add_compare_command(app);
    compare::add_audit_command(app);
}

}  // namespace plumbline
