// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "scenes/read_gltf.h"

namespace plumbline {
namespace {

/// Kinds of primitives by their numbers in the file [glTF 2.0, section 3.7.2.1].
enum Mode { Points, Lines, LineLoop, LineStrip, Triangles, TriangleStrip, TriangleFan };

/// A range of a mesh's positions.
struct Vertices {
    std::size_t first;
    std::size_t count;
};

/// A mesh while its primitives are joined; primitives that share vertices keep sharing them.
struct MeshBeingRead {
    Mesh mesh;
    /// By their accessors: positions, and colours and texture coordinates or -1.
    std::map<std::array<int, 3>, Vertices> vertices;
};

void add_albedo(const JsonView& colours, MeshBeingRead& into, std::size_t first,
                GltfBeingRead& gltf) {
    Mesh& mesh = into.mesh;
    const auto values = gltf.accessors.floats(colours, {"VEC3", "VEC4"});
    if (values.count() != mesh.positions.size() - first) {
        colours.fail(fmt::format("has {} colours for {} positions", values.count(),
                                 mesh.positions.size() - first),
                     "give one a position");
    }
    // Earlier primitives may have gone without.
    mesh.vertex_albedo.resize(first, Spectrum(1.f));
    for (std::size_t i = 0; i < values.count(); ++i) mesh.vertex_albedo.push_back(values.vec3(i));
}

void add_texcoords(const JsonView& places, MeshBeingRead& into, std::size_t first,
                   GltfBeingRead& gltf) {
    Mesh& mesh = into.mesh;
    const auto values = gltf.accessors.floats(places, {"VEC2"});
    if (values.count() != mesh.positions.size() - first) {
        places.fail(fmt::format("has {} texture coordinates for {} positions", values.count(),
                                mesh.positions.size() - first),
                    "give one a position");
    }
    mesh.texcoords.resize(first, glm::vec2(0.f));
    for (std::size_t i = 0; i < values.count(); ++i) {
        mesh.texcoords.emplace_back(values.numbers[2 * i], values.numbers[2 * i + 1]);
    }
}

/// The primitive's vertices, which are added unless they are there.
Vertices vertices_of(const JsonView& attributes, MeshBeingRead& into, GltfBeingRead& gltf) {
    Mesh& mesh = into.mesh;
    const JsonView positions = attributes.at("POSITION");
    const auto colours = attributes.find("COLOR_0");
    const auto texcoords = attributes.find("TEXCOORD_0");
    const std::array key{gltf.accessors.index(positions),
                         colours ? gltf.accessors.index(*colours) : -1,
                         texcoords ? gltf.accessors.index(*texcoords) : -1};
    if (const auto known = into.vertices.find(key); known != into.vertices.end()) {
        return known->second;
    }
    const auto values = gltf.accessors.floats(positions, {"VEC3"});
    const Vertices vertices{mesh.positions.size(), values.count()};
    for (std::size_t i = 0; i < values.count(); ++i) mesh.positions.push_back(values.vec3(i));
    if (colours) {
        add_albedo(*colours, into, vertices.first, gltf);
    } else if (!mesh.vertex_albedo.empty()) {
        mesh.vertex_albedo.resize(mesh.positions.size(), Spectrum(1.f));
    }
    if (texcoords) {
        add_texcoords(*texcoords, into, vertices.first, gltf);
    } else if (!mesh.texcoords.empty()) {
        mesh.texcoords.resize(mesh.positions.size(), glm::vec2(0.f));
    }
    into.vertices.emplace(key, vertices);
    return vertices;
}

/// The primitive's corners in order: its indices, or 0, 1, 2 ...
std::vector<std::uint32_t> corners_of(const JsonView& primitive, std::size_t vertices,
                                      GltfBeingRead& gltf) {
    if (const auto reference = primitive.find("indices")) {
        std::vector<std::uint32_t> indices = gltf.accessors.indices(*reference);
        for (std::size_t i = 0; i < indices.size(); ++i) {
            if (indices[i] < vertices) continue;
            reference->fail(fmt::format("index {} asks for vertex {}", i, indices[i]),
                            fmt::format("there are 0 to {}", vertices - 1));
        }
        return indices;
    }
    std::vector<std::uint32_t> indices(vertices);
    for (std::size_t i = 0; i < vertices; ++i) indices[i] = static_cast<std::uint32_t>(i);
    return indices;
}

/// The corners of triangle `i`, counter-clockwise.
glm::uvec3 triangle(const std::vector<std::uint32_t>& c, std::size_t i, int mode) {
    if (mode == TriangleStrip) return {c[i], c[i + 1 + i % 2], c[i + 2 - i % 2]};
    if (mode == TriangleFan) return {c[i + 1], c[i + 2], c[0]};
    return {c[3 * i], c[3 * i + 1], c[3 * i + 2]};
}

/// A primitive without a material has glTF's default one, which is white.
int material_of(const JsonView& primitive, GltfBeingRead& gltf) {
    Scene& scene = gltf.scene;
    const std::size_t listed = scene.materials.size() - (gltf.default_material ? 1 : 0);
    if (const auto reference = primitive.find("material")) {
        return reference->index(listed, "material");
    }
    if (!gltf.default_material) {
        gltf.default_material = static_cast<int>(listed);
        Material white;
        white.name = gltf.material_names(primitive, "default material", listed);
        white.albedo = Spectrum(1.f);
        scene.materials.push_back(std::move(white));
    }
    return *gltf.default_material;
}

void add_primitive(const JsonView& primitive, MeshBeingRead& into, GltfBeingRead& gltf) {
    const auto mode_given = primitive.find("mode");
    const int mode = mode_given ? mode_given->integer(Points, TriangleFan) : Triangles;
    if (mode < Triangles) return gltf.note("points and lines");
    const JsonView attributes = primitive.at("attributes");
    if (!attributes.find("POSITION")) return gltf.note("primitives without positions");
    if (primitive.find("targets")) gltf.note("morph targets");

    if (attributes.find("NORMAL")) gltf.note("vertex normals: triangles are shaded flat");

    Mesh& mesh = into.mesh;
    const Vertices vertices = vertices_of(attributes, into, gltf);
    const auto corners = corners_of(primitive, vertices.count, gltf);
    if (mode == Triangles && corners.size() % 3 != 0) {
        primitive.fail(fmt::format("has {} corners", corners.size()), "a triangle has three");
    }
    const std::size_t count =
        mode == Triangles ? corners.size() / 3 : std::max<std::size_t>(corners.size(), 2) - 2;
    for (std::size_t i = 0; i < count; ++i) {
        mesh.triangles.push_back(triangle(corners, i, mode) +
                                 static_cast<unsigned>(vertices.first));
    }
    mesh.triangle_materials.resize(mesh.triangles.size(), material_of(primitive, gltf));
}

}  // namespace

void read_gltf_meshes(GltfBeingRead& gltf) {
    const std::vector<JsonView> meshes = gltf.root.items("meshes");
    for (std::size_t index = 0; index < meshes.size(); ++index) {
        const JsonView& item = meshes[index];
        MeshBeingRead read;
        for (const JsonView& primitive : item.at("primitives").items()) {
            add_primitive(primitive, read, gltf);
        }
        if (read.mesh.triangles.empty()) {
            gltf.mesh_shapes.emplace_back();
        } else if (const auto exact = exact_shape(item, read.mesh, gltf.scene)) {
            gltf.mesh_shapes.push_back(*exact);
        } else {
            read.mesh.name = gltf.mesh_names(item, "mesh", index);
            gltf.mesh_shapes.emplace_back(MeshInstance{static_cast<int>(gltf.scene.meshes.size())});
            gltf.scene.meshes.push_back(std::move(read.mesh));
            gltf.mesh_places.push_back(item.pointer());
        }
    }
}

}  // namespace plumbline
