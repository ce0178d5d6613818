// SPDX-License-Identifier: Apache-2.0
#include "reports/commands.h"

namespace plumbline {

void add_ablation_command(CLI::App& app);
void add_budget_command(CLI::App& app);
void add_cost_command(CLI::App& app);
void add_fit_command(CLI::App& app);
void add_frontier_command(CLI::App& app);
void add_leak_command(CLI::App& app);
void add_pictures_command(CLI::App& app);
void add_report_command(CLI::App& app);
void add_sequence_command(CLI::App& app);
void add_stress_command(CLI::App& app);

void add_reports_commands(CLI::App& app) {
    add_ablation_command(app);
    add_budget_command(app);
    add_cost_command(app);
    add_fit_command(app);
    add_frontier_command(app);
    add_leak_command(app);
    add_pictures_command(app);
    add_report_command(app);
    add_sequence_command(app);
    add_stress_command(app);
}

}  // namespace plumbline
