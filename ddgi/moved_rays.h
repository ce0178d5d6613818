// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "ddgi/motion.h"
#include "ddgi/ray_blocks.h"

namespace plumbline::ddgi {

/// Where the light of one lamp comes from: the ways to it are points + t direction with
/// 0 <= t <= length.
struct LampWay {
    glm::vec3 position{0.f};   ///< the ways end here ...
    glm::vec3 direction{0.f};  ///< ... or all go this way, if it is not zero
    float radius = 0.f;        ///< of the ball around `position` that they end in
    float length = 1.f;
    std::vector<SolidMove> solids{};  ///< that no way to the light ends in
};

/// The ways to all lights of a world that something moved in.
std::vector<LampWay> lamp_ways(const World& world, const Motion& motion);

/// The rays of all probes, to be held in vector registers against boxes that moved.
///
/// All answers are conservative: by the margin of the boxes, which is well above rounding.
class ProbeRays {
 public:
    /// `rays` a probe: a multiple of rays_in_block.
    ProbeRays(std::size_t probes, std::size_t rays) : values_(probes, rays) {}

    /// The unit direction of ray `ray` of `probe`.
    void set_direction(std::size_t probe, std::size_t ray, const glm::vec3& direction);
    /// How far it goes, and where the surfel at its end is, if there is one.
    void set_end(std::size_t probe, std::size_t ray, float length, const glm::vec3* surfel);

    /// Sets the bits `mark` in marks[ray] of the rays of `probe`, which stands at `origin`, that
    /// meet `box`.
    void mark_rays(std::size_t probe, const glm::vec3& origin, const OrientedBox& box,
                   std::uint8_t mark, std::span<std::uint8_t> marks) const;
    /// ... and of those with a surfel whose way to the light meets one of the boxes, unless one of
    /// the light's solids stood on it before and still does.
    void mark_shadows(std::size_t probe, const LampWay& light, std::span<const OrientedBox> boxes,
                      std::uint8_t mark, std::span<std::uint8_t> marks) const;

 private:
    enum Value : std::size_t { Dx, Dy, Dz, X, Y, Z, Length, HasSurfel, value_count };
    RayBlocks<value_count> values_;
};

}  // namespace plumbline::ddgi
