// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ddgi/distance_moments.h"
#include "ddgi/irradiance_settings.h"
#include "ddgi/model.h"
#include "ddgi/surfel_light.h"

namespace plumbline::ddgi {

/// Probes after [Majercik et al. 2019]: octahedral maps of irradiance, 8 x 8 texels, and of the
/// moments of distance, which tell how much of a probe a point sees.
///
/// A texel of direction n holds E = pi sum_i w_i L_i / sum_i w_i with w_i = max(0, n . w_i) over
/// the probe's rays. A point takes E(x, n) = sum_p w_p E_p(n) / sum_p w_p over the probes around
/// it, E_p(n) between four texels, w_p the trilinear weight times those of IrradianceSettings. With
/// the default settings all of these are convex means, so that an update contracts by the largest
/// albedo, as conserving's does.
class IrradianceModel final : public ProbeModel {
 public:
    /// `shifted`: each probe has its own rays, unless they turn.
    IrradianceModel(const ProbeGrid& grid, const IrradianceSettings& settings, bool shifted);

    RayPattern pattern(int surfels) const override;
    Reach reach() const override { return Reach::FirstSurface; }
    std::size_t bins(int) const override { return texels_.size(); }
    bool turns_rays() const override { return settings_.turnedRays != 0.; }
    RayPattern turned_pattern(int surfels, int update) const override;
    bool settles() const override { return !turns_rays() && !remembers(); }
    std::optional<int> updates_of_still() const override;
    bool is_linear() const override { return settings_.perceptualGamma == 1.; }
    void take_world(const RayTracer& tracer, const SurfelCache& cache,
                    const Motion* motion) override;
    void take_surfels(const SurfelCache& cache) override;
    void begin_update() override;
    void update(std::span<const float> previous, std::span<float> next) const override;
    Spectrum probe_light(std::span<const float> values, const ReceiverPoint& point) const override;
    Spectrum emitted_light(const ReceiverPoint& point) const override;
    std::map<std::string, double> constants() const override { return named(settings_); }

 private:
    bool remembers() const { return settings_.hysteresis > 0.; }
    std::size_t rays() const { return static_cast<std::size_t>(cache_->surfels().per_probe); }
    float back_shortening() const;
    void weigh(std::size_t surfel);
    /// Of the probes around x, what they count, with sum 1.
    ProbeNeighbours weighted(const glm::vec3& x, const glm::vec3& n,
                             const glm::vec3& to_viewer) const;
    float weight_of(std::size_t probe, const glm::vec3& x, const glm::vec3& n,
                    const glm::vec3& biased) const;
    /// Texels of all probes, (probe * texels + texel).
    using Maps = std::vector<glm::vec4>;

    Maps maps_of(std::span<const float> values) const;
    glm::vec4 texel(std::span<const float> values, std::size_t probe, std::size_t t) const;
    /// E(x, n) from the probes, W m^-2, whose texels are texel_of(probe, texel).
    template <typename Texel>
    Spectrum irradiance(const ProbeNeighbours& around, const glm::vec3& n,
                        const Texel& texel_of) const;
    /// What the ray of `surfel` brings; irradiance_of(surfel) is what the probes give it.
    template <typename Irradiance>
    Spectrum surfel_radiance(std::size_t surfel, const Irradiance& irradiance_of) const;
    /// The texels of a probe, whose rays bring radiance_of(surfel), into `encoded`.
    template <typename Radiance>
    void gather(std::size_t probe, const Radiance& radiance_of, std::span<float> encoded) const;
    std::span<float> texels_of(std::span<float> values, std::size_t probe) const {
        return values.subspan(probe * 3 * texels_.size(), 3 * texels_.size());
    }

    ProbeGrid grid_;
    IrradianceSettings settings_;
    bool shifted_;
    OctahedralTexels texels_;
    ProbeDistances distances_;
    DistanceMoments moments_;
    float kept_ = 0.f;      ///< by a texel at the next update
    bool updated_ = false;  ///< some update has begun
    const SurfelCache* cache_ = nullptr;
    UnfedLight unfed_;
    std::vector<ProbeNeighbours> around_;  ///< what each surfel gathers from
    std::vector<float> emitted_;  ///< probe values of emission and environment; empty if none
};

}  // namespace plumbline::ddgi
