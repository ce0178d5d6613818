// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenes/world.h"

namespace plumbline {

/// The point of the triangle a, b, c nearest to `p` [Ericson 2005, section 5.1.5].
glm::dvec3 nearest_point(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b,
                         const glm::dvec3& c);

/// How far the nearest surface of the world is from `point`; infinite if there is none. Looks at
/// all triangles.
double distance_to_surfaces(const World& world, const glm::vec3& point);

}  // namespace plumbline
