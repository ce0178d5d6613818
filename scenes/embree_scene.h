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

/// The way along a segment as a ray that ends where it does; t_max is above 0 unless the ends are
/// nearer than floats can tell apart, or the same, and nothing is between them.
inline Ray way_along(const Segment& segment) {
    const auto& [a, b] = segment;
    // A surface that `b` lies on is not between: its distance is known to within this much.
    const glm::vec3 way = b - a;
    const float error = position_error(glm::max(largest_coordinate(a), largest_coordinate(b)));
    return {a, way, 1.f - 2.f * error / glm::length(way)};
}

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
    /// The same for each ray; `geometry` is RTC_INVALID_GEOMETRY_ID if there is none.
    struct FoundLanes {
        Lanes<unsigned> geometry, primitive;
        Lanes<float> t, u, v;
        Lanes3 ng;

        Found operator[](std::size_t i) const {
            return {geometry[i], primitive[i], t[i], u[i], v[i], ng[i]};
        }
    };

    /// Builds the BVH; `world` must outlive it. Throws SceneError if Embree runs out of memory.
    explicit EmbreeScene(const World& world);
    ~EmbreeScene();
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    RTCScene scene() const { return scene_; }
    RTCDevice device() const { return device_; }
    Hit hit(const Ray& ray, const Found& found) const;
    /// What hit() is for each ray that met something; moves these together in `found`.
    void hits(const RayLanes& rays, FoundLanes& found, HitLanes& hits) const;

    /// True for the back of a one-sided material.
    bool is_culled(const glm::vec3& direction, const Found& found) const {
        const Geometry& geometry = geometries_[found.geometry];
        const bool back = (glm::dot(found.ng, direction) > 0.f) != geometry.inward;
        return back && (geometry.sides == Sides::One || (geometry.sides == Sides::Mixed &&
                                                         is_one_sided(geometry, found.primitive)));
    }

 private:
    /// Of the materials of a geometry.
    enum class Sides { One, Two, Mixed };
    /// Per Embree geometry: a mesh or a sphere.
    struct Geometry {
        const WorldMesh* mesh = nullptr;
        const WorldSphere* sphere = nullptr;
        bool plain = false;  ///< triangles whose albedo is their material's
        Sides sides = Sides::One;
        bool inward = false;  ///< a sphere whose front is inside
    };

    void attach(RTCGeometry geometry, const Geometry& entry);
    void add(const WorldMesh& mesh);
    void add(const WorldSphere& sphere);
    bool is_plain(const WorldMesh& mesh) const;
    Sides sides_of(const WorldMesh& mesh) const;
    bool is_one_sided(const Geometry& geometry, unsigned primitive) const;
    struct CornerLanes;
    void fetch_triangle(const FoundLanes& found, std::size_t i, CornerLanes& corners,
                        HitLanes& hits) const;
    Hit triangle_hit(const WorldMesh& mesh, const Found& found) const;
    Hit sphere_hit(const WorldSphere& sphere, const Ray& ray, float t) const;

    const World& world_;
    RTCDevice device_;
    RTCScene scene_;
    std::vector<Geometry> geometries_;  // by Embree's geomID
};

}  // namespace plumbline
