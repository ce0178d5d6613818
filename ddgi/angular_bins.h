// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ddgi/angular_storage.h"
#include "ddgi/octants.h"

namespace plumbline::ddgi {

/// The mean radiance of each octant; a look-up integrates the cosine over octants in closed form
/// (see octant_cosines).
class OctantStorage final : public AngularStorage {
 public:
    /// Rays keep to their octants, so no probe shifts them.
    RayPattern pattern(int surfels, bool) const override { return even_pattern(surfels); }
    std::size_t bins() const override { return octant_count; }
    void take_surfels(const SurfelCache& cache) override;
    void store(std::span<const RayLight> rays, std::span<float> values) const override;
    Spectrum irradiance(const ProbeNeighbours& around, std::span<const float> values,
                        const glm::vec3& n) const override;
    Spectrum surfel_irradiance(const ProbeNeighbours& around, std::span<const float> values,
                               const Surfels& surfels, std::size_t surfel) const override;

 private:
    std::vector<OctantCosines> cosines_;  ///< W_d(n) of each surfel: dear, and never new at rest
};

/// The mean radiance of cells of equal solid angle: layers of equal height, each cut into equal
/// sectors. A cell that no ray meets takes the ray nearest to its centre.
///
/// E(n) = pi sum_b v_b max(0, n . c_b) / sum_b max(0, n . c_b), c_b the mean direction of a cell:
/// the integral of the cosine but for cells that the horizon cuts.
class EqualStorage final : public AngularStorage {
 public:
    EqualStorage(int layers, int sectors);
    std::size_t bins() const override { return centres_.size(); }
    void store(std::span<const RayLight> rays, std::span<float> values) const override;
    Spectrum irradiance(const ProbeNeighbours& around, std::span<const float> values,
                        const glm::vec3& n) const override;
    /// The cell that a unit direction falls into.
    std::size_t cell_of(const glm::vec3& w) const;

 private:
    int layers_;
    int sectors_;
    std::vector<glm::vec3> centres_;  ///< mean of w over the cell; shorter than 1
};

}  // namespace plumbline::ddgi
