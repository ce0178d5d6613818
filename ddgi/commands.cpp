// SPDX-License-Identifier: Apache-2.0
#include "ddgi/commands.h"

namespace plumbline {

void add_ddgi_commands(CLI::App&) {}

}  // namespace plumbline
