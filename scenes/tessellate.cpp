// SPDX-License-Identifier: Apache-2.0
#include "scenes/tessellate.h"

#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <utility>

namespace plumbline {
namespace {

/// A face as corners in counter-clockwise order from the front; bit 0, 1, 2 of a corner: the
/// upper x, y, z.
constexpr std::array<std::array<unsigned, 4>, 6> box_face_corners = {{
    {1, 3, 7, 5},  // +x
    {0, 4, 6, 2},  // -x
    {2, 6, 7, 3},  // +y
    {0, 1, 5, 4},  // -y
    {4, 5, 7, 6},  // +z
    {0, 2, 3, 1},  // -z
}};

constexpr unsigned meridians = 48;
constexpr unsigned parallels = 24;

}  // namespace

Mesh mesh_of(const Box& box) {
    Mesh mesh;
    for (unsigned corner = 0; corner < 8; ++corner) {
        mesh.positions.emplace_back((corner & 1u) != 0 ? box.upper.x : box.lower.x,
                                    (corner & 2u) != 0 ? box.upper.y : box.lower.y,
                                    (corner & 4u) != 0 ? box.upper.z : box.lower.z);
    }
    for (std::size_t face = 0; face < box_face_corners.size(); ++face) {
        const auto& [a, b, c, d] = box_face_corners[face];
        mesh.triangles.emplace_back(a, b, c);
        mesh.triangles.emplace_back(a, c, d);
        mesh.triangle_materials.insert(mesh.triangle_materials.end(), 2, box.face_materials[face]);
    }
    return mesh;
}

Mesh mesh_of(const Quad& quad) {
    Mesh mesh;
    mesh.positions = {quad.corner, quad.corner + quad.edge_u,
                      quad.corner + quad.edge_u + quad.edge_v, quad.corner + quad.edge_v};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    mesh.triangle_materials = {quad.material, quad.material};
    return mesh;
}

Mesh mesh_of(const Sphere& sphere) {
    Mesh mesh;
    for (unsigned row = 0; row <= parallels; ++row) {
        const float theta = glm::pi<float>() * static_cast<float>(row) / parallels;
        for (unsigned column = 0; column <= meridians; ++column) {
            const float phi = glm::two_pi<float>() * static_cast<float>(column) / meridians;
            const glm::vec3 direction(std::sin(theta) * std::sin(phi), std::cos(theta),
                                      std::sin(theta) * std::cos(phi));
            mesh.positions.push_back(sphere.center + sphere.radius * direction);
        }
    }
    const auto add = [&](unsigned a, unsigned b, unsigned c) {
        if (sphere.inward) std::swap(b, c);
        mesh.triangles.emplace_back(a, b, c);
    };
    for (unsigned row = 0; row < parallels; ++row) {
        for (unsigned column = 0; column < meridians; ++column) {
            const unsigned upper = row * (meridians + 1) + column;
            const unsigned lower = upper + meridians + 1;
            if (row > 0) add(upper, lower, upper + 1);
            if (row + 1 < parallels) add(upper + 1, lower, lower + 1);
        }
    }
    mesh.triangle_materials.assign(mesh.triangles.size(), sphere.material);
    return mesh;
}

}  // namespace plumbline
