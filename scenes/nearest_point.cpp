// SPDX-License-Identifier: Apache-2.0
#include "scenes/nearest_point.h"

#include <algorithm>
#include <limits>

namespace plumbline {

glm::dvec3 nearest_point(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b,
                         const glm::dvec3& c) {
    const glm::dvec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
    const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
    const double d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
    const double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
    if (d1 <= 0. && d2 <= 0.) return a;
    if (d3 >= 0. && d4 <= d3) return b;
    if (d6 >= 0. && d5 <= d6) return c;
    const double of_c = d1 * d4 - d3 * d2;
    if (of_c <= 0. && d1 >= 0. && d3 <= 0.) return a + ab * (d1 / (d1 - d3));
    const double of_b = d5 * d2 - d1 * d6;
    if (of_b <= 0. && d2 >= 0. && d6 <= 0.) return a + ac * (d2 / (d2 - d6));
    const double of_a = d3 * d6 - d5 * d4;
    if (of_a <= 0. && d4 >= d3 && d5 >= d6) {
        return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
    }
    return a + (ab * of_b + ac * of_c) / (of_a + of_b + of_c);
}

double distance_to_surfaces(const World& world, const glm::vec3& point) {
    const glm::dvec3 p(point);
    double nearest = std::numeric_limits<double>::infinity();
    for (const WorldMesh& mesh : world.meshes) {
        for (const glm::uvec3& t : mesh.triangles) {
            const glm::dvec3 there =
                nearest_point(p, glm::dvec3(mesh.positions[t.x]), glm::dvec3(mesh.positions[t.y]),
                              glm::dvec3(mesh.positions[t.z]));
            nearest = std::min(nearest, glm::length(there - p));
        }
    }
    for (const WorldSphere& sphere : world.spheres) {
        const double off_center = glm::length(p - glm::dvec3(sphere.center));
        nearest = std::min(nearest, std::abs(off_center - double(sphere.radius)));
    }
    return nearest;
}

}  // namespace plumbline
