// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

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

/// The straight way from `a` to `b`.
struct Segment {
    glm::vec3 a;
    glm::vec3 b;
};

/// A start for a ray that leaves `hit` in a direction with a positive component along `n`: off
/// the surface by its rounding error, so that the ray cannot meet the surface it left
/// [Pharr et al. 2023, section 6.8.6].
glm::vec3 offset_origin(const Hit& hit, const glm::vec3& n);

class EmbreeScene;

/// Answers visibility queries on a World with Embree 3. Queries are thread-safe.
class RayTracer {
 public:
    /// Builds the BVH; `world` must outlive it. Throws SceneError if Embree runs out of memory.
    explicit RayTracer(const World& world);
    /// Traces rays that come together in packets of 1, 4, 8 or 16; else the widest that Embree
    /// calls native to the machine.
    RayTracer(const World& world, int packet_width);
    ~RayTracer();
    RayTracer(const RayTracer&) = delete;
    RayTracer& operator=(const RayTracer&) = delete;

    /// The nearest surface that the ray meets.
    std::optional<Hit> intersect(const Ray& ray, BackFaces back_faces) const;

    /// True if something lies strictly between the points `a` and `b`; backs are opaque too.
    bool occluded(const glm::vec3& a, const glm::vec3& b) const;

    /// hits[i] becomes what intersect(rays[i], back_faces) is; as many hits as rays.
    void intersect(std::span<const Ray> rays, BackFaces back_faces, Coherence coherence,
                   std::span<std::optional<Hit>> hits) const;

    /// hidden[i] becomes occluded(segments[i].a, segments[i].b); as many answers as segments.
    void occluded(std::span<const Segment> segments, std::span<bool> hidden) const;

    const World& world() const { return world_; }

 private:
    const World& world_;
    std::unique_ptr<const EmbreeScene> embree_;
    int packet_width_;
};

}  // namespace plumbline
