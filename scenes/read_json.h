// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "scenes/json_view.h"
#include "scenes/scene.h"

namespace plumbline {

/// Reads a scene in Plumbline's JSON format (scenes/library/scene.schema.json). Mesh files are
/// looked up in `folder`; `source` names the text in messages. The result is checked.
/// Throws SceneError.
Scene read_json_scene(const std::string& text, const std::string& source,
                      const std::filesystem::path& folder);

/// The index that a text names. Throws SceneError with the nearest name there is; `what` is the
/// word for the kind of thing that was looked for.
int find_name(const JsonView& name, const std::map<std::string, int>& indices,
              const std::string& what);

/// A scene while it is read: what names stand for.
struct SceneBeingRead {
    std::filesystem::path folder;
    Scene scene;
    std::map<std::string, int> materials;
    std::map<std::string, int> meshes;
    /// For each of scene.materials, meshes, objects and lights, the JSON pointer where it is
    /// written.
    std::vector<std::string> material_places;
    std::vector<std::string> mesh_places;
    std::vector<std::string> object_places;
    std::vector<std::string> light_places;
    std::vector<std::string> directional_light_places;

    /// The material that a text names. Throws SceneError.
    int material(const JsonView& name) const { return find_name(name, materials, "material"); }
    /// Appends a mesh that is written at `item`; its index.
    int add_mesh(Mesh mesh, const JsonView& item);
};

/// The parts of read_json_scene.
void read_meshes(const JsonView& list, SceneBeingRead& into);
void read_objects(const JsonView& list, SceneBeingRead& into);
void read_lights(const JsonView& list, SceneBeingRead& into);

/// Gives the scene's last object its mesh: a name, {"positions", "triangles", ...}, or {"file"}.
void read_object_mesh(const JsonView& mesh, SceneBeingRead& into);

/// Gives the scene's last object the mesh of an OBJ file, or a glTF file's objects as children.
void read_mesh_file(const JsonView& mesh, SceneBeingRead& into);

Transform read_transform(const JsonView& object);
/// The name of a picture, or {"image", "wrap"}.
Texture read_texture(const JsonView& texture, const std::filesystem::path& folder);
Animation read_animation(const JsonView& animation);
Camera read_camera(const JsonView& camera);
ProbeGrid read_probes(const JsonView& probes);
ThesisConstants read_thesis(const JsonView& thesis);

/// Reads what a scene says of itself as a whole: "description", "units", "environment", "frames",
/// "report_frame", "frames_per_second", "probes" and "thesis", each if it is there. Files are
/// looked up in `folder`.
void read_settings(const JsonView& item, const std::filesystem::path& folder, Scene& scene);

}  // namespace plumbline
