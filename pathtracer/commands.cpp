// SPDX-License-Identifier: Apache-2.0
#include "pathtracer/commands.h"

namespace plumbline {

void add_pathtracer_commands(CLI::App& app) {
    pathtracer::add_render_command(app);
    pathtracer::add_merge_command(app);
    pathtracer::add_prove_command(app);
}

}  // namespace plumbline
