// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenes/scene.h"

namespace plumbline::fuzz {

/// What the program does with any scene that it accepted: inspects it, builds its world at its
/// first, middle and last frame, traces rays through it, and writes it as JSON, which must read
/// back. Throws std::logic_error if it does not, and SceneError for a frame that makes no sense.
void use_scene(const Scene& scene);

}  // namespace plumbline::fuzz
