// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ddgi/angular_storage.h"

namespace plumbline::ddgi {

/// The real spherical harmonics of a unit vector, of order 3: Y_00, Y_1-1, Y_10, Y_11, Y_2-2 ...
/// Y_22 [Ramamoorthi and Hanrahan 2001, eq. 3], orthonormal over the sphere.
std::array<float, 9> harmonics(const glm::vec3& w);

/// Radiance in spherical harmonics of order 2 (4 coefficients) or 3 (9).
///
/// E(n) = sum_lm A_l L_lm Y_lm(n) with A = pi, 2 pi / 3, pi / 4 [Ramamoorthi and Hanrahan 2001,
/// eq. 7 and 8]. Where the rays are too few to tell harmonics apart, that of equal rays is not
/// quite pi; the look-up divides by what it is. The kernel dips below 0 where the cosine is 0: E
/// may be negative opposite to a bright light, and its largest value need not shrink by the albedo
/// at each update, though its mean square does.
class HarmonicStorage final : public AngularStorage {
 public:
    /// `order` is 2 or 3.
    HarmonicStorage(const ProbeGrid& grid, int order);
    std::size_t bins() const override;
    void take_surfels(const SurfelCache& cache) override;
    void store(std::span<const RayLight> rays, std::span<float> values) const override;
    Spectrum irradiance(const ProbeNeighbours& around, std::span<const float> values,
                        const glm::vec3& n) const override;

 private:
    std::size_t coefficients() const { return std::size_t(order_) * std::size_t(order_); }

    ProbeGrid grid_;
    int order_;
    std::vector<float> even_;  ///< what a probe keeps of radiance 1 (probe * coefficients + i)
};

}  // namespace plumbline::ddgi
