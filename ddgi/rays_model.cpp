// SPDX-License-Identifier: Apache-2.0
#include "ddgi/rays_model.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <glm/gtc/constants.hpp>

#include "ddgi/look_up.h"

namespace plumbline::ddgi {
namespace {

void put(std::span<float> values, std::size_t probe, std::size_t ray, std::size_t rays,
         const Spectrum& radiance) {
    for (std::size_t c = 0; c < 3; ++c) {
        values[value_index(probe, c, ray, rays)] = radiance[static_cast<int>(c)];
    }
}

}  // namespace

void RaysModel::start(const SurfelCache& cache) {
    cache_ = &cache;
    const std::size_t count = cache.surfels().size();
    ends_.emplace(probe_count(grid_), rays(), grid_.spacing);
    if (options_.feedback == Feedback::Maps) {
        maps_.emplace(grid_);
        gathers_.resize(count);
    }
    unfed_.resize(count);
    reflectance_.resize(count);
    emitted_.assign(count * 3, 0.f);
    emitters_.assign(probe_count(grid_), 0);
}

void RaysModel::take_surfels(const SurfelCache& cache) {
    const bool afresh = cache_ != &cache;
    if (afresh) start(cache);
    tbb::parallel_for(std::size_t{0}, std::size_t{probe_count(grid_)},
                      [&](std::size_t probe) { take_probe(probe, afresh); });
    any_emits_ = std::ranges::any_of(emitters_, [](std::uint8_t emits) { return emits != 0; });
}

void RaysModel::take_probe(std::size_t probe, bool afresh) {
    const glm::vec3 position = probe_position(grid_, static_cast<std::uint32_t>(probe));
    const Surfels& surfels = cache_->surfels();
    const bool others_changed = weigher_.may_change();
    if (!afresh && !others_changed && !cache_->probe_changed(probe)) return;
    bool emits = emitters_[probe] != 0;
    for (std::size_t ray = 0; ray < rays(); ++ray) {
        const std::size_t i = probe * rays() + ray;
        const bool weighs_others = afresh || cache_->sees_others(i) ||
                                   (others_changed && weigher_.changed_at(surfels.position[i]));
        if (weighs_others || cache_->changed(i)) take_surfel(i, weighs_others);
        if (!afresh && !cache_->replaced(i)) continue;
        ends_->set(probe, ray, position, surfels);
        if (surfels.emission[i] != Spectrum(0.f)) emits = true;
    }
    // A probe that nothing is emitted to keeps its zeros.
    if (emits) take_emission(probe);
}

void RaysModel::take_emission(std::size_t probe) {
    const std::span<const Spectrum> emission(&cache_->surfels().emission[probe * rays()], rays());
    const bool emits =
        std::ranges::any_of(emission, [](const Spectrum& Le) { return Le != Spectrum(0.f); });
    for (std::size_t ray = 0; ray < rays(); ++ray) {
        put(emitted_, probe, ray, rays(), emission[ray]);
    }
    emitters_[probe] = emits ? 1 : 0;
}

ProbeNeighbours RaysModel::around(std::size_t surfel) const {
    const Surfels& surfels = cache_->surfels();
    const std::uint8_t seen = surfels.seen.empty() ? all_probes : surfels.seen[surfel];
    return weigher_.weighted(surfels.position[surfel], surfels.n[surfel], seen);
}

void RaysModel::take_surfel(std::size_t surfel, bool weighs_others) {
    const Surfels& surfels = cache_->surfels();
    const bool hit = surfels.hit(surfel);
    const Spectrum reflectance = hit ? surfels.albedo[surfel] / glm::pi<float>() : Spectrum(0.f);
    reflectance_[surfel] = reflectance;
    unfed_[surfel] = surfels.emission[surfel];
    if (hit) unfed_[surfel] += reflectance * surfels.direct[surfel];
    if (!maps_ || !weighs_others) return;
    // A black surfel takes nothing in, unless others show its light.
    const bool fed =
        surfels.source.empty() ? reflectance != Spectrum(0.f) : surfels.own_light(surfel);
    gathers_[surfel] = fed ? maps_->gather(around(surfel), surfels.n[surfel]) : MapGather{};
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

/// E_probes at the surfels of a probe.
void RaysModel::feed(std::span<const float> previous, std::size_t probe,
                     std::span<Spectrum> E) const {
    const std::size_t first = probe * rays();
    if (maps_) {
        maps_->gather(std::span(gathers_).subspan(first, rays()), E);
        return;
    }
    const Surfels& surfels = cache_->surfels();
    for (std::size_t i = first; i < first + rays(); ++i) {
        E[i - first] = reflectance_[i] == Spectrum(0.f)
                           ? Spectrum(0.f)
                           : ray_irradiance(previous, around(i), surfels.position[i], surfels.n[i]);
    }
}

/// What the rays of a probe bring whose surfels take in `E`.
void RaysModel::bring(std::size_t probe, std::span<const Spectrum> E, std::span<float> next) const {
    const std::size_t first = probe * rays();
    for (std::size_t ray = 0; ray < rays(); ++ray) {
        put(next, probe, ray, rays(), unfed_[first + ray] + reflectance_[first + ray] * E[ray]);
    }
}

void RaysModel::update(std::span<const float> previous, std::span<float> next) const {
    if (maps_) maps_->make(*ends_, previous, rays());
    if (!cache_->surfels().source.empty()) {
        update_shared(previous, next);
        return;
    }
    const tbb::blocked_range<std::size_t> all(0, probe_count(grid_));
    tbb::parallel_for(all, [&](const tbb::blocked_range<std::size_t>& probes) {
        std::vector<Spectrum> E(rays());
        for (std::size_t probe = probes.begin(); probe < probes.end(); ++probe) {
            feed(previous, probe, E);
            bring(probe, E, next);
        }
    });
}

/// The same where surfels take in what their sources do: these first.
void RaysModel::update_shared(std::span<const float> previous, std::span<float> next) const {
    const Surfels& surfels = cache_->surfels();
    // Only what sources take in is ever written and read.
    const std::unique_ptr<Spectrum[]> fed(new Spectrum[surfels.size()]);
    for_probes(probe_count(grid_), [&](std::size_t probe) {
        for (std::size_t i = probe * rays(); i < (probe + 1) * rays(); ++i) {
            if (!surfels.own_light(i)) continue;
            if (maps_) {
                maps_->gather({&gathers_[i], 1}, {&fed[i], 1});
            } else {
                fed[i] = ray_irradiance(previous, around(i), surfels.position[i], surfels.n[i]);
            }
        }
    });
    const tbb::blocked_range<std::size_t> all(0, probe_count(grid_));
    tbb::parallel_for(all, [&](const tbb::blocked_range<std::size_t>& probes) {
        std::vector<Spectrum> E(rays());
        for (std::size_t probe = probes.begin(); probe < probes.end(); ++probe) {
            for (std::size_t ray = 0; ray < rays(); ++ray) {
                const std::size_t i = probe * rays() + ray;
                E[ray] = surfels.hit(i) ? fed[surfels.source[i]] : Spectrum(0.f);
            }
            bring(probe, E, next);
        }
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
