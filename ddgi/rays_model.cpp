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
    ends_.emplace(cache.surfels(), grid_.spacing);
    if (options_.feedback == Feedback::Maps) {
        maps_.emplace(grid_);
        gathers_.resize(count);
    }
    emitted_.assign(cache.surfels().emission.size() * 3, 0.f);
}

void RaysModel::take_surfels(const SurfelCache& cache) {
    const bool afresh = cache_ != &cache;
    if (afresh) start(cache);
    const bool others_changed = weigher_.may_change();
    for_probes(probe_count(grid_), [&](std::size_t probe) {
        if (!afresh && !others_changed) {
            cache.for_changed(probe, [&](std::size_t i) {
                take(probe, i, cache.sees_others(i), cache.replaced(i));
            });
            return;
        }
        for (std::size_t i = probe * rays(); i < (probe + 1) * rays(); ++i) {
            const bool weighs = afresh || cache.sees_others(i) ||
                                weigher_.changed_at(cache.surfels().place[i].position);
            take(probe, i, weighs, afresh || cache.replaced(i));
        }
    });
}

/// Takes in a surfel of `probe`: if it `weighs` its probes anew, what it gathers, and if its ray
/// `ended` elsewhere, where.
void RaysModel::take(std::size_t probe, std::size_t surfel, bool weighs, bool ended) {
    if (maps_ && weighs) gathers_[surfel] = gather_of(surfel);
    if (!ended) return;
    const Surfels& surfels = cache_->surfels();
    const std::size_t ray = surfel - probe * rays();
    ends_->set(probe, ray, probe_position(grid_, static_cast<std::uint32_t>(probe)), surfels);
    if (!emitted_.empty()) put(emitted_, probe, ray, rays(), surfels.emission[surfel]);
}

ProbeNeighbours RaysModel::around(std::size_t surfel) const {
    const Surfels& surfels = cache_->surfels();
    const std::uint8_t seen = surfels.seen.empty() ? all_probes : surfels.seen[surfel];
    return weigher_.weighted(surfels.place[surfel].position, surfels.place[surfel].n, seen);
}

/// A black surfel takes nothing in, unless others show its light.
MapGather RaysModel::gather_of(std::size_t surfel) {
    const Surfels& surfels = cache_->surfels();
    const bool fed = surfels.source.empty() ? surfels.light[surfel].albedo != Spectrum(0.f)
                                            : surfels.own_light(surfel);
    return fed ? maps_->gather(around(surfel), surfels.place[surfel].n) : MapGather{};
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
        E[i - first] = surfels.light[i].albedo == Spectrum(0.f)
                           ? Spectrum(0.f)
                           : ray_irradiance(previous, around(i), surfels.place[i].position,
                                            surfels.place[i].n);
    }
}

/// What the rays of a probe bring whose surfels take in `E`.
void RaysModel::bring(std::size_t probe, std::span<const Spectrum> E, std::span<float> next) const {
    const std::size_t count = rays();
    const SurfelLight* light = &cache_->surfels().light[probe * count];
    float* radiance = &next[value_index(probe, 0, 0, count)];
    for (std::size_t ray = 0; ray < count; ++ray) {
        const Spectrum scattered =
            light[ray].albedo * glm::one_over_pi<float>() * (light[ray].direct + E[ray]);
        radiance[ray] = scattered.r;
        radiance[count + ray] = scattered.g;
        radiance[2 * count + ray] = scattered.b;
    }
    if (emitted_.empty()) return;
    const float* emitted = &emitted_[value_index(probe, 0, 0, count)];
    for (std::size_t i = 0; i < 3 * count; ++i) radiance[i] += emitted[i];
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
                fed[i] = ray_irradiance(previous, around(i), surfels.place[i].position,
                                        surfels.place[i].n);
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
    return emitted_.empty() ? Spectrum(0.f) : probe_light(emitted_, point);
}

}  // namespace plumbline::ddgi
