// SPDX-License-Identifier: Apache-2.0
#include "ddgi/octants.h"

#include <cmath>

namespace plumbline::ddgi {
namespace {

using Triangle = std::array<glm::dvec3, 3>;

/// The octant's pole and its two corners on the horizon plane y = 0, in counter-clockwise order
/// seen from outside the sphere.
Triangle octant_corners(const glm::ivec3& principal) {
    const glm::dvec3 pole(0., principal.y, 0.);
    const glm::dvec3 along(principal.x, 0., principal.z);
    const glm::dvec3 across = glm::cross(pole, along);
    const glm::dvec3 right = glm::normalize(along - across);
    const glm::dvec3 left = glm::normalize(along + across);
    return {pole, right, left};
}

/// Half the angle between `a` and `b` along the unit normal of their plane.
glm::dvec3 edge_vector(const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 normal = glm::cross(a, b);
    const double sine = glm::length(normal);
    if (sine == 0.) return glm::dvec3(0.);  // clipping left no edge, and its plane is undefined
    // atan2, since acos(a . b) loses half its digits for short edges.
    return normal * (0.5 * std::atan2(sine, glm::dot(a, b)) / sine);
}

/// Lambert's formula over the part of the triangle above the horizon of n.
double clipped_cosine(const Triangle& corners, const glm::dvec3& n) {
    std::array<glm::dvec3, 4> polygon;  // a triangle cut by one plane has at most four corners
    std::size_t size = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3& a = corners[i];
        const glm::dvec3& b = corners[(i + 1) % corners.size()];
        const double height_a = glm::dot(a, n);
        const double height_b = glm::dot(b, n);
        if (height_a >= 0.) polygon[size++] = a;
        if ((height_a > 0. && height_b < 0.) || (height_a < 0. && height_b > 0.)) {
            const glm::dvec3 crossing =
                height_a > 0. ? height_a * b - height_b * a : height_b * a - height_a * b;
            polygon[size++] = glm::normalize(crossing);
        }
    }
    glm::dvec3 sum(0.);
    for (std::size_t i = 0; i < size; ++i) sum += edge_vector(polygon[i], polygon[(i + 1) % size]);
    return glm::dot(sum, n);
}

}  // namespace

OctantCosines octant_cosines(const glm::vec3& n) {
    static const auto octants = [] {
        std::array<Triangle, octant_count> corners;
        for (std::size_t d = 0; d < corners.size(); ++d) {
            corners[d] = octant_corners(principal_directions[d]);
        }
        return corners;
    }();
    const glm::dvec3 normal(n);
    OctantCosines cosines;
    for (std::size_t d = 0; d < octants.size(); ++d) {
        cosines[d] = static_cast<float>(clipped_cosine(octants[d], normal));
    }
    return cosines;
}

}  // namespace plumbline::ddgi
