// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenes/command_line.h"

namespace plumbline::reports {

/// Without --size, gives the camera's picture about `pixels` pixels in its own proportions.
void set_default_size(Camera& camera, const CommonOptions& options, double pixels);

}  // namespace plumbline::reports
