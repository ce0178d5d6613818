// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <set>

#include "scenes/read_gltf.h"
#include "scenes/tessellate.h"

namespace plumbline {
namespace {

using Shape = GltfBeingRead::Shape;

Shape read_shape(const JsonView& extras, const Scene& scene) {
    extras.expect_keys({"box", "quad", "sphere"});
    const auto material = [&](const JsonView& reference) {
        return reference.index(scene.materials.size(), "material");
    };
    if (const auto item = extras.find("box")) {
        Box box{item->at("lower").vec3(), item->at("upper").vec3(), {}};
        const auto faces = item->at("face_materials").items();
        if (faces.size() != box.face_materials.size()) {
            item->at("face_materials").fail("is not one a face", "write six materials");
        }
        std::transform(faces.begin(), faces.end(), box.face_materials.begin(), material);
        return box;
    }
    if (const auto item = extras.find("quad")) {
        return Quad{item->at("corner").vec3(), item->at("edge_u").vec3(), item->at("edge_v").vec3(),
                    material(item->at("material"))};
    }
    const JsonView item = extras.at("sphere");
    return Sphere{item.at("center").vec3(), item.at("radius").real(), item.at("inward").boolean(),
                  material(item.at("material"))};
}

Bounds bounds_of(const Mesh& mesh) {
    Bounds bounds;
    for (const glm::uvec3& t : mesh.triangles) {
        for (int corner = 0; corner < 3; ++corner) bounds.extend(mesh.positions[t[corner]]);
    }
    return bounds;
}

/// Whether two meshes fill the same bounds with the same materials: a program that edited the
/// mesh knows nothing of the extras beside it.
bool agree(const Mesh& a, const Mesh& b) {
    constexpr float tolerance = 1e-5f;
    const Bounds x = bounds_of(a);
    const Bounds y = bounds_of(b);
    const float off = std::max(max_component(glm::abs(x.lower - y.lower)),
                               max_component(glm::abs(x.upper - y.upper)));
    const auto materials = [](const Mesh& mesh) {
        return std::set<int>(mesh.triangle_materials.begin(), mesh.triangle_materials.end());
    };
    // Bounds skip what is not a number; a mesh with such vertices is left to the checks.
    const bool finite = std::all_of(b.positions.begin(), b.positions.end(), [](const glm::vec3& p) {
        return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    });
    return finite && off <= tolerance * max_component(x.size()) && materials(a) == materials(b);
}

}  // namespace

std::optional<Shape> exact_shape(const JsonView& mesh, const Mesh& vertices, const Scene& scene) {
    const auto extras = plumbline_extras(mesh);
    if (!extras) return std::nullopt;
    const Shape shape = read_shape(*extras, scene);
    const auto mesh_of_shape = [](const auto& s) -> Mesh {
        if constexpr (requires { mesh_of(s); }) return mesh_of(s);
        return {};
    };
    if (!agree(std::visit(mesh_of_shape, shape), vertices)) return std::nullopt;
    return shape;
}

}  // namespace plumbline
