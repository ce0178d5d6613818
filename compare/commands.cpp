// SPDX-License-Identifier: Apache-2.0
#include "compare/commands.h"

namespace plumbline {

void add_compare_commands(CLI::App&) {}

}  // namespace plumbline
