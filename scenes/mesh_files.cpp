// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "scenes/errors.h"
#include "scenes/input_files.h"
#include "scenes/nearest_name.h"
#include "scenes/read_gltf.h"
#include "scenes/read_json.h"
#include "scenes/read_obj.h"

namespace plumbline {
namespace {

void leave_out(const JsonView& file, const std::string& what, Scene& scene) {
    const std::string line = file.text() + ": " + what;
    auto& lines = scene.not_simulated;
    if (std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(line);
}

/// Takes over a material that a file brings; its index in the scene.
int add_material(Material material, const std::string& owner, const JsonView& file,
                 SceneBeingRead& into) {
    material.name = owner + "/" + material.name;
    into.scene.materials.push_back(std::move(material));
    into.material_places.push_back(file.pointer() + ", material " +
                                   in_quotes(into.scene.materials.back().name) + ":");
    return static_cast<int>(into.scene.materials.size()) - 1;
}

/// The scene's index of each material that the OBJ uses, from its .mtl files.
std::vector<int> obj_materials(const JsonView& file, const ObjFile& obj,
                               const std::filesystem::path& path, const std::string& owner,
                               SceneBeingRead& into) {
    std::vector<ObjMaterial> known;
    for (const std::string& library : obj.libraries) {
        const auto materials = read_mtl(file_inside(path.parent_path(), library, file));
        known.insert(known.end(), materials.begin(), materials.end());
    }
    std::vector<int> indices;
    for (const std::string& name : obj.materials) {
        const auto found = std::find_if(known.begin(), known.end(), [&](const ObjMaterial& m) {
            return m.material.name == name;
        });
        if (found == known.end()) {
            file.fail("uses the material " + in_quotes(name) + ", which its .mtl does not define",
                      "give \"material\" beside \"file\"");
        }
        for (const std::string& what : found->left_out) {
            leave_out(file, "material " + in_quotes(name) + ": " + what, into.scene);
        }
        indices.push_back(add_material(found->material, owner, file, into));
    }
    return indices;
}

void add_obj(const JsonView& item, const JsonView& file, const std::filesystem::path& path,
             SceneBeingRead& into) {
    ObjFile obj = read_obj(path);
    const std::size_t object = into.scene.objects.size() - 1;
    const std::string owner = into.scene.objects[object].name;
    std::vector<int>& faces = obj.mesh.triangle_materials;
    if (const auto material = item.find("material")) {
        std::fill(faces.begin(), faces.end(), into.material(*material));
    } else {
        if (std::find(faces.begin(), faces.end(), -1) != faces.end()) {
            file.fail("has faces without a material", "give \"material\" beside \"file\"");
        }
        const auto indices = obj_materials(file, obj, path, owner, into);
        for (int& face : faces) face = indices[static_cast<std::size_t>(face)];
    }
    for (const std::string& what : obj.left_out) leave_out(file, what, into.scene);
    obj.mesh.name = owner;
    into.scene.objects[object].shape = MeshInstance{into.add_mesh(std::move(obj.mesh), item)};
}

/// Refers a shape of a file to the materials and meshes that it brought into the scene.
struct Renumber {
    const std::vector<int>& materials;
    int first_mesh;

    void operator()(int& material) const {
        material = materials[static_cast<std::size_t>(material)];
    }
    void operator()(std::monostate) const {}
    void operator()(Box& box) const {
        for (int& material : box.face_materials) (*this)(material);
    }
    void operator()(Quad& quad) const { (*this)(quad.material); }
    void operator()(Sphere& sphere) const { (*this)(sphere.material); }
    void operator()(MeshInstance& instance) const { instance.mesh += first_mesh; }
};

/// Puts a glTF file's objects below the scene's last one, with their animation.
void add_gltf(const JsonView& item, const JsonView& file, const std::filesystem::path& path,
              SceneBeingRead& into) {
    Scene& scene = into.scene;
    Scene brought = read_gltf_objects(path, scene.frames_per_second);
    const int group = static_cast<int>(scene.objects.size()) - 1;
    const std::string owner = scene.objects.back().name;
    std::vector<int> materials;
    for (const Material& material : brought.materials) {
        const auto given = item.find("material");
        materials.push_back(given ? into.material(*given)
                                  : add_material(material, owner, file, into));
    }
    const Renumber renumber{materials, static_cast<int>(scene.meshes.size())};
    for (Mesh& mesh : brought.meshes) {
        for (int& material : mesh.triangle_materials) renumber(material);
        mesh.name = owner + "/" + mesh.name;
        into.add_mesh(std::move(mesh), item);
    }
    for (Object& object : brought.objects) {
        std::visit(renumber, object.shape);
        object.name = owner + "/" + object.name;
        object.parent = object.parent == -1 ? group : group + 1 + object.parent;
        scene.objects.push_back(std::move(object));
        into.object_places.push_back(item.pointer());
    }
    for (const std::string& what : brought.not_simulated) leave_out(file, what, scene);
    if (!brought.length_unit.empty() && brought.length_unit != scene.length_unit) {
        leave_out(file, "its unit of length, " + in_quotes(brought.length_unit), scene);
    }
}

}  // namespace

void read_mesh_file(const JsonView& item, SceneBeingRead& into) {
    item.expect_keys({"file", "material"});
    const JsonView file = item.at("file");
    const std::filesystem::path path = file_inside(into.folder, file.text(), file);
    const std::string ending = path.extension().string();
    if (ending == ".obj") return add_obj(item, file, path, into);
    if (ending == ".gltf" || ending == ".glb") return add_gltf(item, file, path, into);
    file.fail("meshes are not read from " + in_quotes(ending), "use .obj, .gltf or .glb");
}

}  // namespace plumbline
