// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

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

    /// The unit normal on the side that was hit.
    glm::vec3 n() const { return back ? -ng : ng; }
};

/// What a ray does at the back of a one-sided surface.
enum class BackFaces {
    Hit,   ///< stops, and Hit::back is set: light paths
    Cull,  ///< passes: camera and surfel rays [Dellson 2023]
};

/// A start for a ray that leaves `hit` in a direction with a positive component along `n`: off
/// the surface by its rounding error, so that the ray cannot meet the surface it left
/// [Pharr et al. 2023, section 6.8.6].
glm::vec3 offset_origin(const Hit& hit, const glm::vec3& n);

/// Answers visibility queries on a World with Embree 3. Queries are thread-safe.
class RayTracer {
 public:
    /// Builds the BVH; `world` must outlive it. Throws SceneError if Embree runs out of memory.
    explicit RayTracer(const World& world);
    ~RayTracer();
    RayTracer(const RayTracer&) = delete;
    RayTracer& operator=(const RayTracer&) = delete;

    /// The nearest surface that the ray meets.
    std::optional<Hit> intersect(const Ray& ray, BackFaces back_faces) const;

    /// True if something lies strictly between the points `a` and `b`; backs are opaque too.
    bool occluded(const glm::vec3& a, const glm::vec3& b) const;

    const World& world() const { return world_; }

 private:
    struct Embree;

    const World& world_;
    std::unique_ptr<Embree> embree_;
};

}  // namespace plumbline
