// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scenes/scene.h"

namespace plumbline {

/// An object's triangles in world space.
struct WorldMesh {
    int object;  ///< index into World::objects
    std::vector<glm::vec3> positions;
    std::vector<Spectrum> vertex_albedo;  ///< empty, or one a position
    std::vector<glm::vec2> texcoords;     ///< empty, or one a position
    std::vector<glm::uvec3> triangles;    ///< counter-clockwise from the front, mirrored or not
    std::vector<int> triangle_materials;
};

/// A sphere in world space.
struct WorldSphere {
    int object;  ///< index into World::objects
    glm::vec3 center;
    float radius;
    bool inward;
    int material;
};

/// What both renderers see: a scene at one frame, flattened to world space.
struct World {
    struct Object {
        std::string name;
        glm::mat4 to_world;
        Bounds bounds;  ///< empty for a group
    };

    int frame = 0;
    std::vector<Object> objects;  ///< same order as Scene::objects
    std::vector<WorldMesh> meshes;
    std::vector<WorldSphere> spheres;
    std::vector<Material> materials;
    std::vector<PointLight> lights;                    ///< cones along unit directions
    std::vector<DirectionalLight> directional_lights;  ///< unit directions
    Spectrum environment{0.f};                         ///< see Scene::environment
    std::optional<EnvironmentImage> environment_image;
    Camera camera;
    float reach = 1.f;  ///< farther than any two points of surfaces are apart

    Bounds bounds() const;
    std::size_t triangle_count() const;
};

/// The world at `frame`. Throws SceneError if a sphere is scaled unevenly.
World world_at(const Scene& scene, int frame);

/// Radiance of a ray that leaves the scene in the unit `direction`, W m^-2 sr^-1.
Spectrum environment_radiance(const World& world, const glm::vec3& direction);

/// The grid of the scene, or one laid over the bounds of its first frame: twelve cells along the
/// longest axis, and half a cell or more of margin on every side.
ProbeGrid probe_grid(const Scene& scene);

}  // namespace plumbline
