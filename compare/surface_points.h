// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scenes/ray_tracer.h"

namespace plumbline::compare {

/// A point on the front (or either side, if it has two) of a surface.
struct SurfacePoint {
    glm::vec3 position;  ///< world space, just off the surface
    glm::vec3 n;         ///< unit normal
    Spectrum albedo;
    Spectrum emission;  ///< radiance, W m^-2 sr^-1
};

/// Points spread over all surfaces, each standing for the same area.
struct SurfacePoints {
    std::vector<SurfacePoint> points;
    double area;          ///< that each stands for, in the square of the scene's unit
    double covered_area;  ///< of surfaces that lie against another one, where no point is
};

/// About `count` points, even in area; the same for the same world.
SurfacePoints surface_points(const RayTracer& tracer, int count);

/// A direction around the unit vector `n` with density cos / pi, from `u` in [0,1)^2: a point of
/// the unit sphere that touches the surface, seen from where it touches.
glm::vec3 cosine_direction(const glm::vec2& u, const glm::vec3& n);

}  // namespace plumbline::compare
