// SPDX-License-Identifier: Apache-2.0
#include "ddgi/rays_model.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <glm/gtc/constants.hpp>

#include "ddgi/look_up.h"

namespace plumbline::ddgi {
namespace {

void put(std::span<float> values, std::size_t surfel, std::size_t rays, const Spectrum& radiance) {
    for (std::size_t c = 0; c < 3; ++c) {
        values[value_index(surfel / rays, c, surfel % rays, rays)] = radiance[static_cast<int>(c)];
    }
}

/// pi times the mean of the rays' radiance; 0 if no ray counts.
Spectrum irradiance(const RaySums& sums) {
    if (sums.weight == 0.f) return Spectrum(0.f);
    return sums.radiance * (glm::pi<float>() / sums.weight);
}

}  // namespace

void RaysModel::take_surfels(const SurfelCache& cache) {
    const bool afresh = cache_ != &cache;
    cache_ = &cache;
    const Surfels& surfels = cache.surfels();
    if (afresh) {
        ends_.emplace(probe_count(grid_), rays(), grid_.spacing);
        unfed_.resize(surfels.size());
        around_.resize(surfels.size());
        emitted_.assign(surfels.size() * 3, 0.f);
        emitters_.assign(probe_count(grid_), 0);
    }
    tbb::parallel_for(std::size_t{0}, std::size_t{probe_count(grid_)}, [&](std::size_t probe) {
        bool moved = afresh;
        for (std::size_t i = probe * rays(); i < (probe + 1) * rays(); ++i) {
            moved = moved || cache.replaced(i);
            if (afresh || cache.changed(i) || weigher_.changed_at(surfels.position[i]))
                take_surfel(i);
        }
        if (!moved) return;
        const std::span<const float> emitted(&emitted_[probe * 3 * rays()], 3 * rays());
        emitters_[probe] = std::ranges::any_of(emitted, [](float L) { return L != 0.f; });
        const glm::vec3 position = probe_position(grid_, static_cast<std::uint32_t>(probe));
        ends_->set(probe, position, surfels);
    });
    any_emits_ = std::ranges::any_of(emitters_, [](std::uint8_t emits) { return emits != 0; });
}

void RaysModel::take_surfel(std::size_t surfel) {
    const Surfels& surfels = cache_->surfels();
    const Spectrum emitted = surfels.emission[surfel];
    put(emitted_, surfel, rays(), emitted);
    unfed_[surfel] = emitted;
    if (!surfels.hit(surfel)) return;
    unfed_[surfel] += surfels.albedo[surfel] / glm::pi<float>() * surfels.direct[surfel];
    const std::uint8_t seen = surfels.seen.empty() ? all_probes : surfels.seen[surfel];
    around_[surfel] = weigher_.weighted(surfels.position[surfel], surfels.n[surfel], seen);
}

RaysModel::Maps RaysModel::irradiance_maps(std::span<const float> values) const {
    Maps maps(std::size_t{probe_count(grid_)} * map_nodes);
    tbb::parallel_for(std::size_t{0}, std::size_t{probe_count(grid_)}, [&](std::size_t probe) {
        const float* radiance = &values[probe * 3 * rays()];
        for (std::size_t node = 0; node < map_nodes; ++node) {
            const RaySums sums = ends_->along_rays(probe, map_directions()[node], radiance);
            maps[probe * map_nodes + node] = glm::vec4(irradiance(sums), 0.f);
        }
    });
    return maps;
}

Spectrum RaysModel::map_irradiance(const Maps& maps, const ProbeNeighbours& around,
                                   const glm::vec3& n) const {
    const MapPoint at = map_point(n);
    glm::vec4 E(0.f);
    for (std::size_t k = 0; k < around.probe.size(); ++k) {
        if (around.weight[k] == 0.f) continue;
        const glm::vec4* map = &maps[around.probe[k] * map_nodes];
        for (std::size_t i = 0; i < at.node.size(); ++i) {
            // Walls face an axis, where one node alone counts.
            if (at.weight[i] != 0.f) E += around.weight[k] * at.weight[i] * map[at.node[i]];
        }
    }
    return Spectrum(E);
}

Spectrum RaysModel::ray_irradiance(std::span<const float> values, const ProbeNeighbours& around,
                                   const glm::vec3& x, const glm::vec3& n) const {
    const auto gathered = [&](const auto& sums_of) {
        RaySums all;
        for (std::size_t k = 0; k < around.probe.size(); ++k) {
            if (around.weight[k] == 0.f) continue;
            const std::size_t probe = around.probe[k];
            const RaySums sums = sums_of(probe, &values[probe * 3 * rays()]);
            all.radiance += around.weight[k] * sums.radiance;
            all.weight += around.weight[k] * sums.weight;
        }
        return all;
    };
    if (options_.parallax) {
        const RaySums all = gathered([&](std::size_t probe, const float* radiance) {
            return ends_->from_point(probe, x, n, radiance);
        });
        // Else no ray ends in front of the surface, and only directions tell where light is from.
        if (all.weight > 0.f) return irradiance(all);
    }
    return irradiance(gathered([&](std::size_t probe, const float* radiance) {
        return ends_->along_rays(probe, n, radiance);
    }));
}

Spectrum RaysModel::feedback(const Maps& maps, std::span<const float> previous,
                             std::size_t surfel) const {
    const Surfels& surfels = cache_->surfels();
    const glm::vec3& x = surfels.position[surfel];
    const glm::vec3& n = surfels.n[surfel];
    const ProbeNeighbours& around = around_[surfel];
    return maps.empty() ? ray_irradiance(previous, around, x, n) : map_irradiance(maps, around, n);
}

void RaysModel::update(std::span<const float> previous, std::span<float> next) const {
    const Surfels& surfels = cache_->surfels();
    const Maps maps = options_.feedback == Feedback::Maps ? irradiance_maps(previous) : Maps();
    tbb::parallel_for(std::size_t{0}, surfels.size(), [&](std::size_t i) {
        Spectrum radiance = unfed_[i];
        if (surfels.hit(i) && surfels.albedo[i] != Spectrum(0.f)) {
            radiance += surfels.albedo[i] / glm::pi<float>() * feedback(maps, previous, i);
        }
        put(next, i, rays(), radiance);
    });
}

Spectrum RaysModel::probe_light(std::span<const float> values, const ReceiverPoint& point) const {
    const ProbeNeighbours around = weigher_.weighted(point.position, point.n, point.seen);
    return point.albedo / glm::pi<float>() *
           ray_irradiance(values, around, point.position, point.n);
}

Spectrum RaysModel::emitted_light(const ReceiverPoint& point) const {
    return any_emits_ ? probe_light(emitted_, point) : Spectrum(0.f);
}

}  // namespace plumbline::ddgi
