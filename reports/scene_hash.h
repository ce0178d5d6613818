// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "scenes/scene.h"

namespace plumbline::reports {

/// SHA-1, in hexadecimal, of the file that `plumbline export SCENE -o OUT.json` writes.
/// Throws ImageError if the system's temporary folder cannot be written.
std::string scene_hash(const Scene& scene);

}  // namespace plumbline::reports
