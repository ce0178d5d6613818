// SPDX-License-Identifier: Apache-2.0
#include "ddgi/commands.h"

namespace plumbline {

void add_ddgi_commands(CLI::App& app) { ddgi::add_ddgi_command(app); }

}  // namespace plumbline
