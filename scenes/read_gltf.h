// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "scenes/gltf_accessors.h"
#include "scenes/scene.h"

namespace plumbline {

/// Reads glTF 2.0. What the format cannot say is taken from `extras` under the key "plumbline";
/// what is not simulated is told in Scene::not_simulated. The result is checked.
/// Throws SceneError.
Scene read_gltf_scene(const std::filesystem::path& path);

/// Reads glTF 2.0 for the objects of a scene that plays this many frames a second, in which their
/// keyframes are. Scene::not_simulated tells besides what a whole scene has and they do not bring:
/// lights, a camera, an environment, probes, the thesis's constants. Throws SceneError.
Scene read_gltf_objects(const std::filesystem::path& path, float frames_per_second);

/// Gives names that are missing or stand twice, which glTF allows, a number.
class UniqueNames {
 public:
    std::string operator()(const JsonView& item, const std::string& fallback, std::size_t index);

 private:
    std::set<std::string> taken_;
};

/// A glTF file while it is read.
struct GltfBeingRead {
    GltfBeingRead(const GltfDocument& document, const std::filesystem::path& folder,
                  std::optional<float> host_rate);

    std::filesystem::path folder;  ///< of the file
    /// Frames a second of the scene that the objects are read for; none: the file's own scene.
    std::optional<float> host_rate;
    JsonView root;
    GltfAccessors accessors;
    std::vector<JsonView> nodes;
    std::vector<JsonView> lights;
    std::vector<JsonView> cameras;
    std::map<int, std::shared_ptr<const Picture>> pictures;  ///< read so far, by "images"
    Scene scene;

    /// What a node shows, for each mesh of the file.
    using Shape = decltype(Object::shape);
    std::vector<Shape> mesh_shapes;
    std::optional<int> default_material;
    UniqueNames mesh_names, material_names, object_names, light_names;
    /// For each of scene.meshes, objects and lights, the JSON pointer where it is written.
    std::vector<std::string> mesh_places, object_places, light_places, directional_light_places;
    std::string camera_place;
    bool frames_given = false;
    /// For each node its parent, -1 at the top; none for nodes that are not shown.
    std::vector<std::optional<int>> parents;
    /// For each node, its object, or -1: leaves that only carry a light or a camera have none.
    std::vector<int> node_objects;

    /// Frames a second of all keyframes.
    float rate() const { return host_rate.value_or(scene.frames_per_second); }
    /// Adds a line to Scene::not_simulated unless it stands there.
    void note(const std::string& line);
};

/// What a "baseColorTexture" refers to: a picture beside the file or within it.
Texture read_gltf_texture(const JsonView& reference, GltfBeingRead& gltf);

/// The object under "extras"/"plumbline", if any.
std::optional<JsonView> plumbline_extras(const JsonView& item);
/// The object under "extensions"/`name`, if any.
std::optional<JsonView> extension(const JsonView& item, const std::string& name);

/// The parts of read_gltf_scene.
void read_gltf_materials(GltfBeingRead& gltf);
void read_gltf_meshes(GltfBeingRead& gltf);
/// The box, quad or sphere that a mesh stands for, if its extras say so and its vertices agree.
std::optional<GltfBeingRead::Shape> exact_shape(const JsonView& mesh, const Mesh& vertices,
                                                const Scene& scene);
void read_gltf_nodes(GltfBeingRead& gltf);
/// Plays the file's first animation; needs the nodes.
void read_gltf_animation(GltfBeingRead& gltf);
/// Lights and cameras where they are at frame 0; needs the nodes and the animation.
void read_gltf_carried(GltfBeingRead& gltf);

/// A node that carries a light or a camera, and where it is at frame 0.
struct GltfCarrier {
    std::size_t index;
    const JsonView& node;
    glm::mat4 to_world;
    bool moves;
};
/// Adds the light of this index that the node carries.
void read_gltf_light(const JsonView& reference, const GltfCarrier& at, GltfBeingRead& gltf);

/// A node's own transform.
Transform gltf_transform(const JsonView& node);
/// Which light the node carries, if any.
std::optional<JsonView> gltf_light_of(const JsonView& node);

}  // namespace plumbline
