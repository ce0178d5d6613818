// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ddgi/angular_storage.h"
#include "ddgi/model.h"
#include "ddgi/probe_weigher.h"
#include "ddgi/surfel_light.h"

namespace plumbline::ddgi {

/// Energy-conserving probes that keep the light of their rays by direction, in less than all of
/// it: see AngularStorage.
///
/// A surfel shows a/pi (E_direct + E_probes) + emission, and a ray that meets nothing brings the
/// environment's radiance. Each update is thus a mean times an albedo: with all storages but
/// spherical harmonics, whose weights are not all positive, a contraction in the largest value by
/// the largest albedo of the scene. There is no constant to tune.
class ConservingModel final : public ProbeModel {
 public:
    /// `options.storage` is not Storage::Rays.
    ConservingModel(const ProbeGrid& grid, const ProbeOptions& options)
        : grid_(grid),
          options_(options),
          weigher_(grid, options),
          storage_(make_storage(options.storage, grid)) {}

    RayPattern pattern(int surfels) const override {
        return storage_->pattern(surfels, options_.shifted);
    }
    Reach reach() const override { return Reach::FirstSurface; }
    ProbeWeights weights() const override { return options_.weights; }
    std::size_t bins(int) const override { return storage_->bins(); }
    void take_world(const RayTracer& tracer, const SurfelCache& cache,
                    const Motion* motion) override {
        weigher_.take_world(tracer, cache, motion);
    }
    void take_surfels(const SurfelCache& cache) override;
    void update(std::span<const float> previous, std::span<float> next) const override;
    Spectrum probe_light(std::span<const float> values, const ReceiverPoint& point) const override;
    Spectrum emitted_light(const ReceiverPoint& point) const override;

 private:
    /// Stores what radiance(surfel) of every probe's rays comes to.
    template <typename Radiance>
    void store(std::span<float> values, const Radiance& radiance) const;

    ProbeGrid grid_;
    ProbeOptions options_;
    ProbeWeigher weigher_;
    std::unique_ptr<AngularStorage> storage_;
    const SurfelCache* cache_ = nullptr;
    UnfedLight unfed_;
    std::vector<ProbeNeighbours> around_;  ///< what each surfel gathers from
    std::vector<float> emitted_;  ///< probe values of emission and environment; empty if none
};

}  // namespace plumbline::ddgi
