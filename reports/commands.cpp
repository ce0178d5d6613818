// SPDX-License-Identifier: Apache-2.0
#include "reports/commands.h"

namespace plumbline {

void add_reports_commands(CLI::App&) {}

}  // namespace plumbline
