// SPDX-License-Identifier: Apache-2.0
#include "scenes/command_line.h"

namespace plumbline {

void add_scenes_commands(CLI::App&) {}

}  // namespace plumbline
