// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "scenes/check_parts.h"
#include "scenes/nearest_name.h"

namespace plumbline {
namespace {

void check_mesh(const Mesh& mesh, const std::vector<Material>& all, const Checked& checked) {
    const std::size_t materials = all.size();
    if (mesh.triangles.empty()) checked.fail("triangles", "is empty", "a mesh has triangles");
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        if (finite(mesh.positions[i])) continue;
        checked.fail(fmt::format("positions/{}", i), "is not finite", "write finite numbers");
    }
    if (!mesh.vertex_albedo.empty() && mesh.vertex_albedo.size() != mesh.positions.size()) {
        checked.fail("vertex_albedo",
                     fmt::format("has {} entries for {} positions", mesh.vertex_albedo.size(),
                                 mesh.positions.size()),
                     "give one a position, or none");
    }
    for (std::size_t i = 0; i < mesh.vertex_albedo.size(); ++i) {
        const Spectrum& albedo = mesh.vertex_albedo[i];
        // The negation also catches NaN.
        if (!(min_component(albedo) >= 0.f && max_component(albedo) <= 1.f)) {
            checked.expect_albedo(fmt::format("vertex_albedo/{}", i), albedo);
        }
    }
    if (!mesh.texcoords.empty() && mesh.texcoords.size() != mesh.positions.size()) {
        checked.fail("texcoords",
                     fmt::format("has {} entries for {} positions", mesh.texcoords.size(),
                                 mesh.positions.size()),
                     "give one a position, or none");
    }
    for (std::size_t i = 0; i < mesh.texcoords.size(); ++i) {
        if (finite(mesh.texcoords[i].x) && finite(mesh.texcoords[i].y)) continue;
        checked.fail(fmt::format("texcoords/{}", i), "is not finite", "write finite numbers");
    }
    if (mesh.triangle_materials.size() != mesh.triangles.size()) {
        checked.fail("triangle_materials",
                     fmt::format("has {} entries for {} triangles", mesh.triangle_materials.size(),
                                 mesh.triangles.size()),
                     "give one a triangle");
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const glm::uvec3& t = mesh.triangles[i];
        const unsigned largest = glm::max(t.x, glm::max(t.y, t.z));
        if (largest >= mesh.positions.size()) {
            checked.fail(
                fmt::format("triangles/{}", i), fmt::format("asks for vertex {}", largest),
                fmt::format("the mesh has {} vertices, counted from 0", mesh.positions.size()));
        }
        const int material = mesh.triangle_materials[i];
        if (material < 0 || std::size_t(material) >= materials) {
            checked.expect_index(fmt::format("triangle_materials/{}", i), material, materials,
                                 "material");
        }
        if (mesh.texcoords.empty() && all[std::size_t(material)].texture) {
            checked.fail("texcoords",
                         "are missing, but material " + in_quotes(all[std::size_t(material)].name) +
                             " has a texture",
                         "give one a position");
        }
    }
}

}  // namespace

void check_materials(const Scene& scene, const PlaceOf& place_of) {
    std::set<std::string> names;
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        const Material& material = scene.materials[i];
        const Checked checked(place_of, "materials", i);
        checked.expect_new_name(material.name, names);
        checked.expect_albedo("albedo", material.albedo);
        checked.expect_not_negative("emission", material.emission);
    }
}

void check_meshes(const Scene& scene, const PlaceOf& place_of) {
    std::set<std::string> names;
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
        const Checked checked(place_of, "meshes", i);
        checked.expect_new_name(scene.meshes[i].name, names);
        check_mesh(scene.meshes[i], scene.materials, checked);
    }
}

}  // namespace plumbline
