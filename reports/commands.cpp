// SPDX-License-Identifier: Apache-2.0
#include "reports/commands.h"

namespace plumbline {

void add_fit_command(CLI::App& app);
void add_report_command(CLI::App& app);

void add_reports_commands(CLI::App& app) {
    add_fit_command(app);
    add_report_command(app);
}

}  // namespace plumbline
