// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "scenes/read_json.h"

namespace plumbline {
namespace {

void read_positions(const JsonView& item, Mesh& mesh) {
    const JsonView positions = item.at("positions");
    for (const JsonView& position : positions.items()) mesh.positions.push_back(position.vec3());
    if (mesh.positions.empty()) positions.fail("is empty", "a mesh has vertices");
    if (const auto albedo = item.find("vertex_albedo")) {
        for (const JsonView& value : albedo->items()) mesh.vertex_albedo.push_back(value.vec3());
    }
    if (const auto texcoords = item.find("texcoords")) {
        for (const JsonView& value : texcoords->items()) {
            const auto uv = value.numbers(2);
            mesh.texcoords.emplace_back(static_cast<float>(uv[0]), static_cast<float>(uv[1]));
        }
    }
}

void read_triangles(const JsonView& item, const SceneBeingRead& read, Mesh& mesh) {
    const int last = static_cast<int>(mesh.positions.size()) - 1;
    for (const JsonView& triangle : item.at("triangles").items()) {
        mesh.triangles.emplace_back(triangle.ivec3(0, last));
    }
    const auto material = item.find("material");
    const auto materials = item.find("triangle_materials");
    if (material.has_value() == materials.has_value()) {
        item.fail("must say its materials once",
                  "give either \"material\", or \"triangle_materials\" with one a triangle");
    }
    if (material) {
        mesh.triangle_materials.assign(mesh.triangles.size(), read.material(*material));
        return;
    }
    for (const JsonView& name : materials->items()) {
        mesh.triangle_materials.push_back(read.material(name));
    }
}

/// Reads a mesh written in the scene file itself.
Mesh read_inline_mesh(const JsonView& item, const SceneBeingRead& read) {
    item.expect_keys({"name", "positions", "triangles", "vertex_albedo", "texcoords", "material",
                      "triangle_materials"});
    Mesh mesh;
    read_positions(item, mesh);
    read_triangles(item, read, mesh);
    return mesh;
}

}  // namespace

int SceneBeingRead::add_mesh(Mesh mesh, const JsonView& item) {
    const int index = static_cast<int>(scene.meshes.size());
    meshes.emplace(mesh.name, index);
    scene.meshes.push_back(std::move(mesh));
    mesh_places.push_back(item.pointer());
    return index;
}

void read_meshes(const JsonView& list, SceneBeingRead& into) {
    for (const JsonView& item : list.items()) {
        Mesh mesh = read_inline_mesh(item, into);
        mesh.name = item.at("name").text();
        into.add_mesh(std::move(mesh), item);
    }
}

void read_object_mesh(const JsonView& item, SceneBeingRead& into) {
    if (item.is_object() && item.find("file")) return read_mesh_file(item, into);
    const std::size_t object = into.scene.objects.size() - 1;
    int index = 0;
    if (item.is_string()) {
        index = find_name(item, into.meshes, "mesh");
    } else {
        Mesh mesh = read_inline_mesh(item, into);
        mesh.name = into.scene.objects[object].name;
        index = into.add_mesh(std::move(mesh), item);
    }
    into.scene.objects[object].shape = MeshInstance{index};
}

}  // namespace plumbline
