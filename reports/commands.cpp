// SPDX-License-Identifier: Apache-2.0
#include "reports/commands.h"

namespace plumbline {

void add_fit_command(CLI::App& app);

void add_reports_commands(CLI::App& app) { add_fit_command(app); }

}  // namespace plumbline
