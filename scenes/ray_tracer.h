// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "scenes/lanes.h"
#include "scenes/world.h"

namespace plumbline {

/// A point on a surface.
struct Hit {
    float t;             ///< distance along the ray, in units of its direction's length
    glm::vec3 position;  ///< world space; rounded by at most `position_error` per coordinate
    float position_error;
    glm::vec3 ng;  ///< geometric unit normal of the front, whichever side was hit
    bool back;     ///< the back was hit
    int object;    ///< index into World::objects
    int material;  ///< index into World::materials
    Spectrum albedo;
    unsigned geometry;   ///< index into World::meshes and, behind them, World::spheres
    unsigned primitive;  ///< the mesh's triangle; 0 for a sphere

    /// The unit normal on the side that was hit.
    glm::vec3 n() const { return back ? -ng : ng; }
};

/// What a ray does at the back of a one-sided surface.
enum class BackFaces {
    Hit,   ///< stops, and Hit::back is set: light paths
    Cull,  ///< passes: camera and surfel rays [Dellson 2023]
};

/// Whether rays that stand next to each other are likely to meet the same surfaces. It changes how
/// fast the answer comes, never the answer.
enum class Coherence { Incoherent, Coherent };

/// A start for a ray that leaves the surface at `position` in a direction with a positive component
/// along `n`: off the surface by its rounding error, so that the ray cannot meet the surface it
/// left [Pharr et al. 2023, section 6.8.6].
inline glm::vec3 offset_origin(const glm::vec3& position, float position_error,
                               const glm::vec3& n) {
    // The error box seen along n: beyond it the point is on the side of n for sure.
    const glm::vec3 size = glm::abs(n);
    return position + n * (position_error * (size.x + size.y + size.z));
}
inline glm::vec3 offset_origin(const Hit& hit, const glm::vec3& n) {
    return offset_origin(hit.position, hit.position_error, n);
}

/// What rays met: `count` points, in the order of the rays that met any.
struct HitLanes {
    std::size_t count = 0;
    Lanes<std::uint32_t> ray;  ///< which ray met it
    Lanes<float> t;
    Lanes3 position;
    Lanes<float> position_error;
    Lanes3 n;  ///< on the side that was hit
    Lanes<std::int32_t> back;
    Lanes<int> object, material;
    Lanes3 albedo;
    Lanes<unsigned> geometry, primitive;

    Hit operator[](std::size_t i) const {
        return {t[i],         position[i], position_error[i], back[i] != 0 ? -n[i] : n[i],
                back[i] != 0, object[i],   material[i],       albedo[i],
                geometry[i],  primitive[i]};
    }
    void set(std::size_t i, const Hit& hit) {
        t[i] = hit.t;
        position.set(i, hit.position);
        position_error[i] = hit.position_error;
        n.set(i, hit.n());
        back[i] = hit.back ? 1 : 0;
        object[i] = hit.object;
        material[i] = hit.material;
        albedo.set(i, hit.albedo);
        geometry[i] = hit.geometry;
        primitive[i] = hit.primitive;
    }
};

class EmbreeScene;

/// Answers visibility queries on a World with Embree 3. Queries are thread-safe.
class RayTracer {
 public:
    /// Builds the BVH; `world` must outlive it. Throws SceneError if Embree runs out of memory.
    explicit RayTracer(const World& world);
    /// Traces rays that come in lanes in packets of 1, 4, 8 or 16; else the widest that Embree
    /// calls native to the machine.
    RayTracer(const World& world, int packet_width);
    ~RayTracer();
    RayTracer(const RayTracer&) = delete;
    RayTracer& operator=(const RayTracer&) = delete;

    /// The nearest surface that the ray meets.
    std::optional<Hit> intersect(const Ray& ray, BackFaces back_faces) const;

    /// True if something lies strictly between the points `a` and `b`; backs are opaque too.
    bool occluded(const glm::vec3& a, const glm::vec3& b) const;

    /// What intersect(ray, back_faces) is for each of the rays that meet something.
    void intersect(const RayLanes& rays, BackFaces back_faces, Coherence coherence,
                   HitLanes& hits) const;

    /// hidden[i] becomes occluded(a, b) for the segment i; as many answers as segments.
    void occluded(const SegmentLanes& segments, Lanes<std::int32_t>& hidden) const;

    const World& world() const { return world_; }

 private:
    const World& world_;
    std::unique_ptr<const EmbreeScene> embree_;
    int packet_width_;
};

}  // namespace plumbline
