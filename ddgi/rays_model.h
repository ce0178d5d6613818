// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ddgi/feedback_maps.h"
#include "ddgi/model.h"
#include "ddgi/probe_weigher.h"
#include "ddgi/ray_gather.h"

namespace plumbline::ddgi {

/// Energy-conserving probes that keep the radiance of every ray.
///
/// A pixel gathers from all rays of the probes around it, E = pi sum w t L / sum w t with w the
/// probe's weight and t >= 0 that of the ray (see RayEnds). Surfels, of which there are many more,
/// gather from a map of irradiances that each probe makes of its rays once an update, unless
/// ProbeOptions::feedback asks for the rays.
/// Both are convex means times pi. A surfel shows a/pi (E_direct + E_probes) + emission, and a ray
/// that meets nothing brings the environment's radiance. So each update is a contraction in the
/// largest value, by the largest albedo of the scene. There is no constant to tune.
class RaysModel final : public ProbeModel {
 public:
    RaysModel(const ProbeGrid& grid, const ProbeOptions& options)
        : grid_(grid), options_(options), weigher_(grid, options) {}

    RayPattern pattern(int surfels) const override {
        return sphere_pattern(surfels, options_.shifted);
    }
    Reach reach() const override { return Reach::FirstSurface; }
    ProbeWeights weights() const override { return options_.weights; }
    std::size_t bins(int surfels) const override { return static_cast<std::size_t>(surfels); }
    void take_world(const RayTracer& tracer, const SurfelCache& cache,
                    const Motion* motion) override {
        weigher_.take_world(tracer, cache, motion);
    }
    void take_surfels(const SurfelCache& cache) override;
    void update(std::span<const float> previous, std::span<float> next) const override;
    Spectrum probe_light(std::span<const float> values, const ReceiverPoint& point) const override;
    Spectrum emitted_light(const ReceiverPoint& point) const override;

 private:
    std::size_t rays() const { return static_cast<std::size_t>(cache_->surfels().per_probe); }
    void start(const SurfelCache& cache);
    void take(std::size_t probe, std::size_t surfel, bool weighs, bool ended);
    MapGather gather_of(std::size_t surfel);
    ProbeNeighbours around(std::size_t surfel) const;
    Spectrum ray_irradiance(std::span<const float> values, const ProbeNeighbours& around,
                            const glm::vec3& x, const glm::vec3& n) const;
    void feed(std::span<const float> previous, std::size_t probe, std::span<Spectrum> E) const;
    void bring(std::size_t probe, std::span<const Spectrum> E, std::span<float> next) const;
    void update_shared(std::span<const float> previous, std::span<float> next) const;

    ProbeGrid grid_;
    ProbeOptions options_;
    ProbeWeigher weigher_;
    const SurfelCache* cache_ = nullptr;
    std::optional<RayEnds> ends_;
    std::optional<FeedbackMaps> maps_;  ///< none with Feedback::Rays
    std::vector<MapGather> gathers_;    ///< what each surfel gathers from the maps
    std::vector<float> emitted_;        ///< probe values of emission and environment; empty if none
};

}  // namespace plumbline::ddgi
