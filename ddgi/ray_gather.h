// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "ddgi/ray_blocks.h"
#include "ddgi/surfels.h"

namespace plumbline::ddgi {

/// Sums over a probe's rays for a surface point: sum_i t_i L_i per channel, and sum_i t_i. The
/// probe's part in the irradiance is pi times their ratio: a convex mean, whatever the t_i.
struct RaySums {
    Spectrum radiance{0.f};
    float weight = 0.f;
};

/// Where the rays of all probes ended, to be summed over in vector registers.
///
/// A ray that met nothing ends on a far sphere around its probe.
class RayEnds {
 public:
    /// Of the rays of `surfels`, none of which has ended yet. `spacing` is the grid's: what is far
    /// is measured by it.
    RayEnds(const Surfels& surfels, float spacing);

    /// Takes in the surfel of ray `ray` of `probe`, which stands at `position`.
    void set(std::size_t probe, std::size_t ray, const glm::vec3& position, const Surfels& surfels);

    /// t_i = max(0, n . w_i) with w_i the ray's direction at the probe: no parallax.
    /// `radiance` are the probe's values, channel by channel.
    RaySums along_rays(std::size_t probe, const glm::vec3& n, const float* radiance) const;

    /// t_i = max(0, n . u_i) times the solid angle of the ray's patch of surface as seen from `x`
    /// over that seen from the probe, u_i the unit direction from `x` to the patch.
    ///
    /// A ray stands for the patch that its solid angle cuts from the surface at its end y_i: of
    /// area d_i^2 / cos_i per steradian. From x the patch covers cos'_i / |y_i - x|^2 per area.
    /// The ratio is kept within [1 / most_magnified, most_magnified]: a patch so near that x sees
    /// it much larger is no longer small, and the formula would let it outshine all others.
    RaySums from_point(std::size_t probe, const glm::vec3& x, const glm::vec3& n,
                       const float* radiance) const;

    static constexpr float most_magnified = 8.f;

 private:
    enum Value : std::size_t { Dx, Dy, Dz, X, Y, Z, Nx, Ny, Nz, PatchArea, value_count };
    float far_;
    RayBlocks<value_count> values_;
};

}  // namespace plumbline::ddgi
