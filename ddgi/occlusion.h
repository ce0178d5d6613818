// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scenes/ray_tracer.h"

namespace plumbline::ddgi {

/// Of each way whether something lies strictly between its ends, as RayTracer::occluded() tells;
/// traced together, which takes less than half the time.
std::vector<std::uint8_t> occluded(const RayTracer& tracer, const std::vector<Segment>& ways);

}  // namespace plumbline::ddgi
