// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "pathtracer/passes.h"
#include "scenes/image.h"

namespace plumbline::pathtracer {

/// The picture so far, in the layers that the README lists.
///
/// albedo, normal and depth are box-filtered means over those of a pixel's samples that hit a
/// surface, and 0 where none did; depth.Z is measured along the view axis. object.Y is what the ray
/// through the pixel's centre meets, -1 for nothing. variance.* and variance_indirect.* are absent
/// with one sample a pixel, which cannot tell. Pixels outside the shard are 0, -1 in object.Y.
Image picture(const RayTracer& tracer, const Passes& passes);

}  // namespace plumbline::pathtracer
