// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "pathtracer/light_tree.h"
#include "pathtracer/lights.h"

namespace plumbline::pathtracer {

/// All surfaces of a world that emit, to be aimed at from any point of a surface.
class Emitters {
 public:
    /// `world` must outlive it.
    explicit Emitters(const World& world);

    /// No surface emits; then nothing below may be called.
    bool empty() const { return emitters_.empty(); }
    std::size_t size() const { return emitters_.size(); }

    /// A direction from `position`, on a surface of unit normal `n`, to a point of an emitter.
    struct Sample {
        glm::vec3 target;  ///< on the emitter, or just in front of it
        Spectrum Le{0.f};  ///< radiance that arrives along it unless something is in between
        float cosine;      ///< with `n`, above 0
        float pdf;         ///< per unit of solid angle, above 0
    };
    /// None if the direction is below the surface, meets a black side, or no emitter is in reach.
    std::optional<Sample> sample(const glm::vec3& position, const glm::vec3& n, float choice,
                                 const glm::vec2& u) const;

    /// The density, per unit of solid angle, with which sample() aims from `position` at the point
    /// `hit` of an emitter, on a side that emits.
    float pdf(const Hit& hit, const glm::vec3& position, const glm::vec3& n) const;

 private:
    /// A triangle, or a sphere.
    struct Emitter {
        int mesh;  ///< index into World::meshes, or -1 for a sphere
        std::uint32_t primitive;
        Spectrum Le;
        bool two_sided;
    };
    /// Where a sample lies on its emitter, and its density by solid angle given the emitter.
    struct Point {
        glm::vec3 target;
        glm::vec3 wi;
        float pdf;
    };

    void add_mesh(const WorldMesh& mesh, int index, std::vector<LightBounds>& bounds);
    void add_sphere(const WorldSphere& sphere, int index, std::vector<LightBounds>& bounds);
    std::optional<Point> sample_triangle(const Emitter& emitter, const glm::vec3& position,
                                         const glm::vec2& u) const;
    std::optional<Point> sample_sphere(const Emitter& emitter, const glm::vec3& position,
                                       const glm::vec2& u) const;
    float triangle_area(const Emitter& emitter) const;

    const World& world_;
    std::vector<Emitter> emitters_;
    /// For each geometry of a Hit, the emitter of its first primitive; those of a mesh are in
    /// order. Of a geometry without emitters, and of primitives that do not emit: none.
    std::vector<std::vector<std::uint32_t>> emitter_of_;
    LightTree tree_;
};

}  // namespace plumbline::pathtracer
