// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "ddgi/patterns.h"

namespace plumbline::ddgi {

/// W_d(n) for all octants d, steradians times cosine.
using OctantCosines = std::array<float, octant_count>;

/// W_d(n): the integral of max(0, n . w) over the directions w of octant d, steradians times
/// cosine. A surface with unit normal `n` under radiance L_d from octant d has irradiance sum_d L_d
/// W_d(n); the eight sum to pi for every n.
///
/// Closed form: Lambert's polygon formula on the octant, a spherical triangle, clipped at the
/// horizon of n [Arvo 1995, "Applications of irradiance tensors", eq. 13].
OctantCosines octant_cosines(const glm::vec3& n);

}  // namespace plumbline::ddgi
