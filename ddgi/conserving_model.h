// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ddgi/model.h"
#include "ddgi/octants.h"

namespace plumbline::ddgi {

/// Energy-conserving octants. A probe stores, per octant, the mean radiance that arrives through
/// it; a surface under it gathers sum_d L_d W_d(n) (see octant_cosines).
///
/// A surfel shows a/pi (E_direct + E_probes) + emission, and a ray that meets nothing brings the
/// environment's radiance. Each update is thus a convex mean times an albedo: a contraction in
/// the largest value, by the largest albedo of the scene. There is no constant to tune.
class ConservingModel final : public ProbeModel {
 public:
    ConservingModel(const ProbeGrid& grid, ProbeWeights weights) : grid_(grid), weights_(weights) {}

    RayPattern pattern(int surfels) const override { return even_pattern(surfels); }
    Reach reach() const override { return Reach::FirstSurface; }
    ProbeWeights weights() const override { return weights_; }
    std::size_t bins(int) const override { return octant_count; }
    void take_surfels(const SurfelCache& cache) override;
    void update(std::span<const float> previous, std::span<float> next) const override;
    Spectrum probe_light(std::span<const float> values, const ReceiverPoint& point) const override;
    Spectrum emitted_light(const ReceiverPoint& point) const override;

 private:
    /// Per probe, channel and octant, the mean of radiance(surfel) over its rays.
    template <typename Radiance>
    void average(std::span<float> values, const Radiance& radiance) const;

    ProbeGrid grid_;
    ProbeWeights weights_;
    const SurfelCache* cache_ = nullptr;
    std::vector<OctantCosines> cosines_;  ///< W_d(n) of each surfel
    std::vector<Spectrum> unfed_;         ///< radiance each surfel ray brings without any feedback
    std::vector<float> emitted_;  ///< probe values of emission and environment; empty if none
};

}  // namespace plumbline::ddgi
