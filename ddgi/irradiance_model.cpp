// SPDX-License-Identifier: Apache-2.0
#include "ddgi/irradiance_model.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "ddgi/look_up.h"

namespace plumbline::ddgi {
namespace {

constexpr int map_side = 8;           // [Majercik et al. 2019]
constexpr float wrapped_least = .2f;  // what a probe right behind counts [Majercik et al. 2019]
constexpr float back_distance = .2f;  // what is left of it [Majercik et al. 2021]

/// A still whose rays turn never settles. It is updated until this is left of the error at the
/// start, in a scene of this mean albedo.
constexpr double left_of_start = .01;
constexpr double usual_albedo = .5;

float wrap_weight(float cosine) {
    const float wrapped = (cosine + 1.f) / 2.f;
    return wrapped * wrapped + wrapped_least;
}

/// Continuous at the threshold.
float crushed(float weight, float threshold) {
    return weight < threshold ? weight * weight * weight / (threshold * threshold) : weight;
}

}  // namespace

IrradianceModel::IrradianceModel(const ProbeGrid& grid, const IrradianceSettings& settings,
                                 bool shifted)
    : grid_(grid),
      settings_(settings),
      shifted_(shifted),
      texels_(map_side),
      moments_(grid, static_cast<int>(settings.depthSharpness)) {}

RayPattern IrradianceModel::pattern(int surfels) const {
    return sphere_pattern(surfels, shifted_ && !turns_rays());
}

RayPattern IrradianceModel::turned_pattern(int surfels, int update) const {
    return turned(pattern(surfels), update);
}

std::optional<int> IrradianceModel::updates_of_still() const {
    if (!turns_rays()) return std::nullopt;
    const double shrinks_by = settings_.hysteresis + (1. - settings_.hysteresis) * usual_albedo;
    return static_cast<int>(std::ceil(std::log(left_of_start) / std::log(shrinks_by)));
}

float IrradianceModel::back_shortening() const {
    return settings_.blackBacks != 0. ? back_distance : 1.f;
}

void IrradianceModel::take_world(const RayTracer& tracer, const SurfelCache& cache,
                                 const Motion* motion) {
    distances_.trace(tracer, cache, motion);
    if (settings_.chebyshev != 0. && !remembers())
        moments_.take(distances_, cache.surfels(), back_shortening());
}

void IrradianceModel::take_surfels(const SurfelCache& cache) {
    const bool afresh = cache_ == nullptr;
    cache_ = &cache;
    const Surfels& surfels = cache.surfels();
    unfed_.take(cache, afresh);
    around_.resize(surfels.size());
    if (!remembers()) {
        tbb::parallel_for(std::size_t{0}, surfels.size(), [&](std::size_t i) {
            if (!surfels.own_light(i)) return;
            const auto near = probe_neighbours(grid_, surfels.place[i].position).probe;
            if (afresh || cache.changed(i) ||
                std::ranges::any_of(near, [&](auto probe) { return distances_.changed(probe); }))
                weigh(i);
        });
    }
    emitted_.clear();
    if (surfels.emission.empty()) return;
    emitted_.resize(probe_count(grid_) * 3 * texels_.size());
    tbb::parallel_for(std::size_t{0}, std::size_t{probe_count(grid_)}, [&](std::size_t probe) {
        gather(
            probe, [&](std::size_t i) { return surfels.emission[i]; }, texels_of(emitted_, probe));
    });
}

void IrradianceModel::begin_update() {
    kept_ = updated_ ? static_cast<float>(settings_.hysteresis) : 0.f;
    updated_ = true;
    if (!remembers()) return;
    const Surfels& surfels = cache_->surfels();
    if (settings_.chebyshev != 0.) moments_.blend(distances_, surfels, back_shortening(), kept_);
    tbb::parallel_for(std::size_t{0}, surfels.size(), [&](std::size_t i) {
        if (surfels.own_light(i)) weigh(i);
    });
}

void IrradianceModel::weigh(std::size_t surfel) {
    const Surfels& surfels = cache_->surfels();
    around_[surfel] = weighted(surfels.place[surfel].position, surfels.place[surfel].n,
                               -surfels.direction[surfel]);
}

float IrradianceModel::weight_of(std::size_t probe, const glm::vec3& x, const glm::vec3& n,
                                 const glm::vec3& biased) const {
    if (settings_.skipInside != 0. && distances_.inside(probe)) return 0.f;
    const glm::vec3 way = probe_position(grid_, static_cast<std::uint32_t>(probe)) - x;
    const float distance = glm::length(way);
    const float cosine = distance > 0.f ? glm::dot(way, n) / distance : 1.f;
    const bool wraps = settings_.wrapShading != 0.;
    if (!wraps && cosine <= 0.f) return 0.f;
    float weight = wraps ? wrap_weight(cosine) : 1.f;
    if (settings_.chebyshev != 0.) {
        const float visibility = std::pow(moments_.visibility(probe, biased),
                                          static_cast<float>(settings_.visibilityPower));
        weight *= std::max(visibility, static_cast<float>(settings_.leastVisibility));
    }
    return crushed(weight, static_cast<float>(settings_.crushThreshold));
}

ProbeNeighbours IrradianceModel::weighted(const glm::vec3& x, const glm::vec3& n,
                                          const glm::vec3& to_viewer) const {
    const auto along_normal = static_cast<float>(settings_.normalBias);
    const auto along_view = static_cast<float>(settings_.viewBias);
    const glm::vec3 biased = x + grid_.spacing * (along_normal * n + along_view * to_viewer);
    return tempered(probe_neighbours(grid_, x), [&](std::size_t, std::uint32_t probe) {
        return weight_of(probe, x, n, biased);
    });
}

template <typename Texel>
Spectrum IrradianceModel::irradiance(const ProbeNeighbours& around, const glm::vec3& n,
                                     const Texel& texel_of) const {
    const TexelBlend blend = texels_.at(n);
    const auto gamma = static_cast<float>(settings_.perceptualGamma);
    glm::vec4 sum(0.f);
    for (std::size_t k = 0; k < around.probe.size(); ++k) {
        if (around.weight[k] == 0.f) continue;
        glm::vec4 E(0.f);
        for (std::size_t t = 0; t < blend.texel.size(); ++t)
            E += blend.weight[t] * texel_of(around.probe[k], blend.texel[t]);
        if (gamma != 1.f) E = glm::pow(E, glm::vec4(gamma / 2.f));
        sum += around.weight[k] * E;
    }
    return Spectrum(gamma == 1.f ? sum : sum * sum);
}

/// The channels of each texel side by side: surfels look them up in no order, and far more often
/// than an update writes them.
IrradianceModel::Maps IrradianceModel::maps_of(std::span<const float> values) const {
    const std::size_t count = texels_.size();
    Maps maps(values.size() / 3);
    tbb::parallel_for(std::size_t{0}, std::size_t{probe_count(grid_)}, [&](std::size_t probe) {
        for (std::size_t t = 0; t < count; ++t) maps[probe * count + t] = texel(values, probe, t);
    });
    return maps;
}

glm::vec4 IrradianceModel::texel(std::span<const float> values, std::size_t probe,
                                 std::size_t t) const {
    const auto channel = [&](std::size_t c) {
        return values[value_index(probe, c, t, texels_.size())];
    };
    return {channel(0), channel(1), channel(2), 0.f};
}

template <typename Irradiance>
Spectrum IrradianceModel::surfel_radiance(std::size_t surfel,
                                          const Irradiance& irradiance_of) const {
    const Surfels& surfels = cache_->surfels();
    if (settings_.blackBacks != 0. && distances_.back(surfel)) return Spectrum(0.f);
    const Spectrum& albedo = surfels.light[surfel].albedo;
    if (!surfels.hit(surfel) || albedo == Spectrum(0.f)) return unfed_[surfel];
    const auto taken_in = static_cast<float>(settings_.energyPreservation);
    return unfed_[surfel] + taken_in * albedo / glm::pi<float>() * irradiance_of(surfel);
}

template <typename Radiance>
void IrradianceModel::gather(std::size_t probe, const Radiance& radiance_of,
                             std::span<float> encoded) const {
    std::vector<RayLight> light;
    light.reserve(rays());
    for (std::size_t i = probe * rays(); i < (probe + 1) * rays(); ++i)
        light.push_back({cache_->surfels().direction[i], radiance_of(i)});
    texels_.irradiance(light, encoded);
    const auto exponent = static_cast<float>(1. / settings_.perceptualGamma);
    if (exponent == 1.f) return;
    for (float& value : encoded) value = std::pow(value, exponent);
}

void IrradianceModel::update(std::span<const float> previous, std::span<float> next) const {
    const Maps maps = maps_of(previous);
    const Surfels& surfels = cache_->surfels();
    const auto at_surfel = [&](std::size_t i) {
        return irradiance(around_[i], surfels.place[i].n, [&](std::size_t probe, std::size_t t) {
            return maps[probe * texels_.size() + t];
        });
    };
    const std::vector<Spectrum> shared = at_sources(surfels, at_surfel);
    const auto irradiance_of = [&](std::size_t i) {
        return shared.empty() ? at_surfel(i) : shared[surfels.source[i]];
    };
    tbb::parallel_for(std::size_t{0}, std::size_t{probe_count(grid_)}, [&](std::size_t probe) {
        const std::span<float> texels = texels_of(next, probe);
        gather(
            probe, [&](std::size_t i) { return surfel_radiance(i, irradiance_of); }, texels);
        if (kept_ == 0.f) return;
        const float* before = &previous[probe * texels.size()];
        for (std::size_t i = 0; i < texels.size(); ++i)
            texels[i] = kept_ * before[i] + (1.f - kept_) * texels[i];
    });
}

Spectrum IrradianceModel::probe_light(std::span<const float> values,
                                      const ReceiverPoint& point) const {
    const ProbeNeighbours around = weighted(point.position, point.n, point.to_viewer);
    const Spectrum E = irradiance(
        around, point.n, [&](std::size_t probe, std::size_t t) { return texel(values, probe, t); });
    return point.albedo / glm::pi<float>() * E;
}

Spectrum IrradianceModel::emitted_light(const ReceiverPoint& point) const {
    return emitted_.empty() ? Spectrum(0.f) : probe_light(emitted_, point);
}

}  // namespace plumbline::ddgi
