// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "ddgi/octahedral.h"
#include "ddgi/probe_distances.h"

namespace plumbline::ddgi {

/// Per probe, an octahedral map of 16 x 16 texels of the mean distance to the scene and the mean
/// squared distance [Majercik et al. 2019]: with them the share of a texel's directions
/// in which the scene is farther than a point can be bounded without a ray to it.
class DistanceMoments {
 public:
    /// A texel takes the rays near its direction n, with weights max(0, n . w)^sharpness.
    DistanceMoments(const ProbeGrid& grid, int sharpness);

    /// Takes in the distances of the probes where they changed. With `back_shortening` below 1 a
    /// ray that met a back counts with this share of its distance: such a probe stands in
    /// something.
    void take(const ProbeDistances& distances, const Surfels& surfels, float back_shortening = 1.f);
    /// The same, but every moment keeps the share `kept` of what it was.
    void blend(const ProbeDistances& distances, const Surfels& surfels, float back_shortening,
               float kept);

    /// Chebyshev's one-sided inequality: at most which share of the probe's view towards `x` is
    /// farther away than x. 1 if x is nearer than the mean.
    float visibility(std::size_t probe, const glm::vec3& x) const;

 private:
    struct Moments {
        float mean;
        float mean_square;
    };
    void take_probe(const ProbeDistances& distances, const Surfels& surfels, float back_shortening,
                    float kept, std::size_t probe);

    ProbeGrid grid_;
    int sharpness_;
    OctahedralTexels texels_;
    std::vector<Moments> moments_;  ///< (probe * texels + texel), in spacings
};

}  // namespace plumbline::ddgi
