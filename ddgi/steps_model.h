// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ddgi/octants.h"
#include "ddgi/thesis_model.h"

namespace plumbline::ddgi {

/// The steps that lead from [Dellson 2023] to energy-conserving octants, each of which can be taken
/// alone, and other ways to pass light on from probe to probe. With none of them the model is
/// `thesis`; with all it is octants that conserve energy.
struct Steps {
    /// A pixel multiplies probe light by its own albedo.
    bool receiverAlbedo = false;
    /// A ray counts with its solid angle, not with the cosine at the probe over the squared
    /// distance.
    bool solidAngle = false;
    /// A look-up gathers sum_d L_d W_d(n) / pi (see octant_cosines), and nothing scales or clamps.
    bool octantLookUp = false;
    /// Rays stand for equal solid angles.
    bool evenRays = false;
    /// Rays run to the first surface instead of reading the neighbour after one cell.
    bool firstSurface = false;
    /// Surfels take in last frame's probe light; without octantLookUp by the scene's own
    /// multiBounceIntensity.
    bool multiBounce = false;
    /// A ray that meets nothing within a cell brings all that the neighbour on the diagonal holds
    /// of its octant, not a share by falloffRegulator; beyond the grid it is dark.
    bool diagonalNeighbour = false;
    /// Such a ray brings what the grid holds of its octant where it ends, between the probes there;
    /// beyond the grid it is dark. Takes precedence.
    bool gridAtEnd = false;
};

/// Probes with some of the steps taken.
class StepsModel final : public ProbeModel {
 public:
    /// `constants` act where no step has removed them. Throws UsageError if the grid has fewer than
    /// three probes along an axis.
    StepsModel(const Steps& steps, const ThesisConstants& constants, const ProbeGrid& grid);

    RayPattern pattern(int surfels) const override;
    Reach reach() const override;
    bool samples_edges() const override { return false; }  // as published
    std::size_t bins(int) const override { return octant_count; }
    void take_surfels(const SurfelCache& cache) override;
    void update(std::span<const float> previous, std::span<float> next) const override;
    Spectrum probe_light(std::span<const float> values, const ReceiverPoint& point) const override;
    Spectrum ambient(const Spectrum& albedo) const override { return constants_.ambient * albedo; }
    std::map<std::string, double> constants() const override;

 private:
    Spectrum look_up_at(std::span<const float> values, const glm::vec3& x,
                        const glm::vec3& n) const;
    Spectrum surfel_radiance(std::span<const float> previous, std::size_t surfel) const;
    float ray_weight(std::size_t surfel) const;
    /// What a ray of octant `d` brings that met nothing within its reach.
    Spectrum missed_radiance(std::span<const float> previous, std::uint32_t probe, std::size_t d,
                             const glm::vec3& direction) const;

    Steps steps_;
    ThesisConstants constants_;
    ProbeGrid grid_;
    const SurfelCache* cache_ = nullptr;
    std::vector<float> ray_shares_;  ///< of its octant, which each ray stands for; they sum to 1
};

/// The model whose steps `set` names, each 0 or 1, with the scene's constants of the thesis.
/// Throws UsageError for an unknown step or another value.
ModelSetup make_steps(const Scene& scene, const ProbeGrid& grid,
                      const std::map<std::string, double>& set);

}  // namespace plumbline::ddgi
