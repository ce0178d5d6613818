// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <embree3/rtcore.h>

#include <vector>

#include "scenes/ray_tracer.h"

namespace plumbline {

/// Rounding of a point interpolated in a triangle, and of Embree's own distance to the triangle
/// from a point this near, for coordinates up to `largest_coordinate`, in units of length.
///
/// In units of float epsilon / 2: gamma_7 of [Pharr et al. 2023, section 6.8.4] for the point, as
/// much again for the distance, and a margin.
inline float position_error(float largest_coordinate) {
    constexpr float error_in_half_epsilons = 32.f;
    return error_in_half_epsilons * std::numeric_limits<float>::epsilon() / 2.f *
           largest_coordinate;
}

inline float largest_coordinate(const glm::vec3& p) { return max_component(glm::abs(p)); }

/// A world's surfaces in Embree, and what stands behind Embree's numbers for them.
class EmbreeScene {
 public:
    /// What Embree tells of the nearest surface on a ray.
    struct Found {
        unsigned geometry;
        unsigned primitive;
        float t;
        float u, v;    ///< barycentric
        glm::vec3 ng;  ///< not normalised; oriented by the winding, for a sphere outward
    };

    /// Builds the BVH; `world` must outlive it. Throws SceneError if Embree runs out of memory.
    explicit EmbreeScene(const World& world);
    ~EmbreeScene();
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    RTCScene scene() const { return scene_; }
    RTCDevice device() const { return device_; }
    Hit hit(const Ray& ray, const Found& found) const;

    /// True for the back of a one-sided material.
    bool is_culled(const glm::vec3& direction, const Found& found) const;

 private:
    /// Per Embree geometry: one of the two.
    struct Geometry {
        const WorldMesh* mesh = nullptr;
        const WorldSphere* sphere = nullptr;
    };

    void attach(RTCGeometry geometry, const Geometry& entry);
    void add(const WorldMesh& mesh);
    void add(const WorldSphere& sphere);
    Hit triangle_hit(const WorldMesh& mesh, const Found& found) const;
    Hit sphere_hit(const WorldSphere& sphere, const Ray& ray, float t) const;

    const World& world_;
    RTCDevice device_;
    RTCScene scene_;
    std::vector<Geometry> geometries_;  // by Embree's geomID
};

inline Hit EmbreeScene::triangle_hit(const WorldMesh& mesh, const Found& found) const {
    const glm::uvec3& triangle = mesh.triangles[found.primitive];
    const glm::vec3& a = mesh.positions[triangle.x];
    const glm::vec3& b = mesh.positions[triangle.y];
    const glm::vec3& c = mesh.positions[triangle.z];
    const float u = found.u;
    const float v = found.v;
    Hit hit;
    hit.object = mesh.object;
    hit.material = mesh.triangle_materials[found.primitive];
    // Interpolated, not origin + t direction, whose error grows with the distance.
    hit.position = (1.f - u - v) * a + u * b + v * c;
    hit.position_error = position_error(
        glm::max(largest_coordinate(a), glm::max(largest_coordinate(b), largest_coordinate(c))));
    hit.ng = glm::normalize(found.ng);
    const Material& material = world_.materials[static_cast<std::size_t>(hit.material)];
    hit.albedo = material.albedo;
    const auto between_corners = [&](const auto& values) {
        return (1.f - u - v) * values[triangle.x] + u * values[triangle.y] + v * values[triangle.z];
    };
    if (!mesh.vertex_albedo.empty()) hit.albedo *= between_corners(mesh.vertex_albedo);
    if (material.texture) hit.albedo *= material.texture->at(between_corners(mesh.texcoords));
    return hit;
}

inline Hit EmbreeScene::sphere_hit(const WorldSphere& sphere, const Ray& ray, float t) const {
    Hit hit;
    hit.object = sphere.object;
    hit.material = sphere.material;
    const glm::vec3 outward = glm::normalize(ray.origin + t * ray.direction - sphere.center);
    hit.position = sphere.center + sphere.radius * outward;
    hit.position_error = position_error(largest_coordinate(sphere.center) + sphere.radius);
    hit.ng = sphere.inward ? -outward : outward;
    hit.albedo = world_.materials[static_cast<std::size_t>(hit.material)].albedo;
    return hit;
}

inline Hit EmbreeScene::hit(const Ray& ray, const Found& found) const {
    const Geometry& geometry = geometries_[found.geometry];
    Hit hit = geometry.mesh != nullptr ? triangle_hit(*geometry.mesh, found)
                                       : sphere_hit(*geometry.sphere, ray, found.t);
    hit.t = found.t;
    hit.geometry = found.geometry;
    hit.primitive = found.primitive;
    hit.back = glm::dot(hit.ng, ray.direction) > 0.f;
    return hit;
}

}  // namespace plumbline
