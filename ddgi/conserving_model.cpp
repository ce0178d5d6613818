// SPDX-License-Identifier: Apache-2.0
#include "ddgi/conserving_model.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <glm/gtc/constants.hpp>

#include "ddgi/look_up.h"

namespace plumbline::ddgi {
namespace {

/// E(x, n) from the probes, W m^-2.
Spectrum irradiance(const ProbeNeighbours& around, std::span<const float> values,
                    std::span<const float> cosines) {
    const auto [r, g, b] = look_up<float>(around, cosines, values);
    return {r, g, b};
}

}  // namespace

template <typename Radiance>
void ConservingModel::average(std::span<float> values, const Radiance& radiance) const {
    const std::size_t per_octant = cache_->pattern().per_octant();
    const auto average_octant = [&](std::size_t probe, std::size_t d) {
        Spectrum sum(0.f);
        const std::size_t first = (probe * octant_count + d) * per_octant;
        for (std::size_t i = first; i < first + per_octant; ++i) sum += radiance(i);
        for (std::size_t c = 0; c < 3; ++c) {
            values[value_index(probe, c, d, octant_count)] =
                sum[static_cast<int>(c)] / static_cast<float>(per_octant);
        }
    };
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, probe_count(grid_)),
                      [&](const tbb::blocked_range<std::size_t>& probes) {
                          for (std::size_t p = probes.begin(); p < probes.end(); ++p) {
                              for (std::size_t d = 0; d < octant_count; ++d) average_octant(p, d);
                          }
                      });
}

void ConservingModel::take_surfels(const SurfelCache& cache) {
    cache_ = &cache;
    const Surfels& surfels = cache.surfels();
    const auto emitted = [&](std::size_t i) { return surfels.emission[i]; };
    unfed_.resize(surfels.size());
    cosines_.resize(surfels.size());
    std::atomic<bool> any_emits = false;
    tbb::parallel_for(std::size_t{0}, surfels.size(), [&](std::size_t i) {
        unfed_[i] = emitted(i);
        if (unfed_[i] != Spectrum(0.f)) any_emits = true;
        if (!surfels.hit(i)) return;
        if (cache.replaced(i)) cosines_[i] = octant_cosines(surfels.n[i]);
        unfed_[i] += surfels.albedo[i] / glm::pi<float>() * surfels.direct[i];
    });
    emitted_.clear();
    if (!any_emits) return;
    emitted_.resize(probe_count(grid_) * 3 * octant_count);
    average(emitted_, [&](std::size_t i) { return emitted(i); });
}

void ConservingModel::update(std::span<const float> previous, std::span<float> next) const {
    const Surfels& surfels = cache_->surfels();
    average(next, [&](std::size_t i) {
        if (!surfels.hit(i) || surfels.albedo[i] == Spectrum(0.f)) return unfed_[i];
        const std::uint8_t seen = surfels.seen.empty() ? all_probes : surfels.seen[i];
        const ProbeNeighbours around =
            weighted_probes(grid_, surfels.position[i], surfels.n[i], weights_, seen);
        const Spectrum E = irradiance(around, previous, cosines_[i]);
        return unfed_[i] + surfels.albedo[i] / glm::pi<float>() * E;
    });
}

Spectrum ConservingModel::probe_light(std::span<const float> values,
                                      const ReceiverPoint& point) const {
    const ProbeNeighbours around =
        weighted_probes(grid_, point.position, point.n, weights_, point.seen);
    const Spectrum E = irradiance(around, values, octant_cosines(point.n));
    return point.albedo / glm::pi<float>() * E;
}

Spectrum ConservingModel::emitted_light(const ReceiverPoint& point) const {
    return emitted_.empty() ? Spectrum(0.f) : probe_light(emitted_, point);
}

}  // namespace plumbline::ddgi
