// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>

#include "ddgi/render.h"

namespace plumbline::ddgi {

/// Called with a frame's figures and its picture.
using FramePlayed = std::function<void(const FrameFigures& figures, const Image& picture)>;

/// Plays `frames` of a scene, in this order, as a viewer sees them: each moves the geometry, gives
/// the probes one update, and takes a picture. The first starts from empty probes.
///
/// Of `options`, `updates` does not count. Throws UsageError as render() does.
void play(const Scene& scene, std::span<const int> frames, const DdgiOptions& options,
          const FramePlayed& played);

}  // namespace plumbline::ddgi
