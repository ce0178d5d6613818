// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ddgi/model.h"
#include "ddgi/thesis_formulas.h"

namespace plumbline::ddgi {

/// The thesis's constants for a scene on a grid, and one line for each choice that was made.
///
/// Those of the scene, or the Cornell Box's if it has none. Where `grid` has another spacing than
/// they were set for, falloffRegulator is scaled to keep what a missed ray brings. Feedback is off,
/// as in the published pictures, unless `set` turns it on. `set` overrides each by name.
/// Throws UsageError for an unknown name or a value that is negative or not finite.
ThesisConstants thesis_constants(const Scene& scene, const ProbeGrid& grid,
                                 const std::map<std::string, double>& set,
                                 std::vector<std::string>& notes);

/// Why the thesis's model cannot run on a grid; none if it can. What a ray of one cell brings that
/// meets nothing is read from a neighbour, at the border inward: three probes along each axis.
std::optional<std::string> thesis_obstacle(const ProbeGrid& grid);

/// [Dellson 2023] by its published formulas.
class ThesisModel final : public ProbeModel {
 public:
    /// Throws UsageError if thesis_obstacle() says why it cannot run on the grid.
    ThesisModel(const ThesisConstants& constants, const ProbeGrid& grid);

    RayPattern pattern(int surfels) const override { return thesis_pattern(surfels); }
    Reach reach() const override { return Reach::OneCell; }
    bool samples_edges() const override { return false; }
    std::size_t bins(int) const override { return octant_count; }
    void take_surfels(const SurfelCache& cache) override;
    void update(std::span<const float> previous, std::span<float> next) const override;
    Spectrum probe_light(std::span<const float> values, const ReceiverPoint& point) const override;
    Spectrum ambient(const Spectrum& albedo) const override { return constants_.ambient * albedo; }
    std::map<std::string, double> constants() const override;

 private:
    bool feedback() const { return constants_.multiBounceIntensity > 0.f; }
    ThesisField field() const { return {grid_, cache_->pattern(), cache_->surfels()}; }

    ThesisConstants constants_;
    ThesisParameters<float> parameters_;
    ProbeGrid grid_;
    const SurfelCache* cache_ = nullptr;
    std::vector<float> miss_shares_;
    std::vector<float> lit_;  ///< without feedback: the same at every update
};

}  // namespace plumbline::ddgi
