// SPDX-License-Identifier: Apache-2.0
#include "ddgi/conserving_model.h"

#include <tbb/parallel_for.h>

#include <glm/gtc/constants.hpp>

namespace plumbline::ddgi {

template <typename Radiance>
void ConservingModel::store(std::span<float> values, const Radiance& radiance) const {
    const Surfels& surfels = cache_->surfels();
    const auto rays = static_cast<std::size_t>(surfels.per_probe);
    const std::size_t per_probe = 3 * storage_->bins();
    tbb::parallel_for(std::size_t{0}, std::size_t{probe_count(grid_)}, [&](std::size_t probe) {
        std::vector<RayLight> light;
        light.reserve(rays);
        for (std::size_t i = probe * rays; i < (probe + 1) * rays; ++i)
            light.push_back({surfels.direction[i], radiance(i)});
        storage_->store(light, values.subspan(probe * per_probe, per_probe));
    });
}

void ConservingModel::take_surfels(const SurfelCache& cache) {
    const bool afresh = cache_ == nullptr;
    cache_ = &cache;
    storage_->take_surfels(cache);
    unfed_.take(cache, afresh);
    const Surfels& surfels = cache.surfels();
    around_.resize(surfels.size());
    tbb::parallel_for(std::size_t{0}, surfels.size(), [&](std::size_t i) {
        const glm::vec3& x = surfels.place[i].position;
        if (!surfels.own_light(i)) return;
        if (!afresh && !cache.changed(i) && !weigher_.changed_at(x)) return;
        const std::uint8_t seen = surfels.seen.empty() ? all_probes : surfels.seen[i];
        around_[i] = weigher_.weighted(x, surfels.place[i].n, seen);
    });
    emitted_.clear();
    if (surfels.emission.empty()) return;
    emitted_.resize(probe_count(grid_) * 3 * storage_->bins());
    store(emitted_, [&](std::size_t i) { return surfels.emission[i]; });
}

void ConservingModel::update(std::span<const float> previous, std::span<float> next) const {
    const Surfels& surfels = cache_->surfels();
    const auto irradiance_of = [&](std::size_t i) {
        return storage_->surfel_irradiance(around_[i], previous, surfels, i);
    };
    const std::vector<Spectrum> shared = at_sources(surfels, irradiance_of);
    store(next, [&](std::size_t i) {
        if (!surfels.hit(i) || surfels.light[i].albedo == Spectrum(0.f)) return unfed_[i];
        const Spectrum E = shared.empty() ? irradiance_of(i) : shared[surfels.source[i]];
        return unfed_[i] + surfels.light[i].albedo / glm::pi<float>() * E;
    });
}

Spectrum ConservingModel::probe_light(std::span<const float> values,
                                      const ReceiverPoint& point) const {
    const ProbeNeighbours around = weigher_.weighted(point.position, point.n, point.seen);
    const Spectrum E = storage_->irradiance(around, values, point.n);
    return point.albedo / glm::pi<float>() * E;
}

Spectrum ConservingModel::emitted_light(const ReceiverPoint& point) const {
    return emitted_.empty() ? Spectrum(0.f) : probe_light(emitted_, point);
}

}  // namespace plumbline::ddgi
