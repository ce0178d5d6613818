// SPDX-License-Identifier: Apache-2.0
#include "pathtracer/passes.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

#include "pathtracer/kernels.h"

namespace plumbline::pathtracer {
namespace {

/// With a batch of samples a pixel, a wave is large enough to fill packets of rays for many bounces
/// and small enough for the second-level cache.
constexpr int pixels_a_wave = 64;

int rows_a_wave(const Tiles::Part& part) {
    return pixels_a_wave / (part.colour ? Tiles::side / 2 : Tiles::side);
}

bool is_finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Keeps the first pixel, row by row from the top, whatever the order in which they are found.
void set_if_earlier(std::optional<glm::ivec2>& first, const glm::ivec2& at) {
    if (!first || std::pair(at.y, at.x) < std::pair(first->y, first->x)) first = at;
}

std::vector<Tiles::Part> parts_of(const Camera& camera, const Shard& shard, Sampling sampling) {
    const Tiles tiles(camera.width, camera.height);
    if (sampling == Sampling::Even) return tiles.parts_of(shard);
    assert(shard == Shard{});
    return tiles.halves();
}

}  // namespace

/// The samples [first, last) of the pixels in the rows [top, bottom), in groups of `group`.
struct Passes::Range {
    int first, last, group;
    int top, bottom;
};

Passes::Passes(const RayTracer& tracer, Effects effects, const PathOptions& options,
               std::uint64_t seed, const Shard& shard, Sampling sampling)
    : tracer_(tracer),
      effects_(effects),
      emitters_(has(effects, Effect::EmitterSampling) ? new Emitters(tracer.world()) : nullptr),
      environment_(has(effects, Effect::EnvironmentImage) && tracer.world().environment_image
                       ? new EnvironmentMap(tracer.world())
                       : nullptr),
      lights_(has(effects, Effect::LightChoice) ? new LightChoice(tracer.world()) : nullptr),
      options_(options),
      seed_(seed),
      camera_rays_(tracer.world().camera),
      forward_(unit_length(tracer.world().camera.target - tracer.world().camera.eye)),
      parts_(parts_of(tracer.world().camera, shard, sampling)) {
    const Camera& camera = tracer.world().camera;
    if (emitters_ && !emitters_->empty()) options_.emitters = emitters_.get();
    options_.environment = environment_.get();
    options_.lights = lights_.get();
    gathered_.pixels.resize(std::size_t(camera.width) * std::size_t(camera.height));
    gathered_.rays.resize(parts_.size());
}

const PixelEstimate& Passes::pixel(const glm::ivec2& at) const {
    const auto width = static_cast<std::size_t>(tracer_.world().camera.width);
    return gathered_.pixels[std::size_t(at.y) * width + std::size_t(at.x)];
}

const PixelEstimate& Passes::first_of(const Tiles::Part& part) const {
    return pixel(part.first_pixel());
}

std::uint64_t Passes::steps(int samples) const {
    std::uint64_t pixels = 0;
    for (const Tiles::Part& part : parts_) pixels += std::uint64_t(part.pixels());
    return pixels * std::uint64_t(samples);
}

bool Passes::between_passes() const {
    const std::vector<int> wanted = gathered_.allocation.samples(samples(), parts_);
    return std::equal(
        parts_.begin(), parts_.end(), wanted.begin(),
        [&](const Tiles::Part& part, int samples) { return samples_of(part) == samples; });
}

double Passes::rays_to(int samples) const {
    const std::vector<int> wanted = gathered_.allocation.samples(samples, parts_);
    double rays = 0.;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        const int has = samples_of(parts_[i]);
        rays += double(gathered_.rays[i]) / has * std::max(0, wanted[i] - has);
    }
    return rays;
}

std::uint64_t Passes::rays() const {
    return std::accumulate(gathered_.rays.begin(), gathered_.rays.end(), std::uint64_t(0));
}

void Passes::share_out() {
    if (!gathered_.allocation.shares.empty()) return;
    std::vector<HalfCost> costs;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        costs.push_back(
            cost_of(parts_[i], pixels(), tracer_.world().camera.width, gathered_.rays[i]));
    }
    gathered_.allocation = allocate(samples(), parts_, costs);
}

bool Passes::add(const Pass& pass, Progress& progress, const std::function<bool()>& stop) {
    bool complete = false;
    with_effects(effects_, [&]<Effects F>() { complete = add_with<F>(pass, progress, stop); });
    if (complete) gathered_.samples = pass.samples;
    return complete;
}

template <Effects F>
bool Passes::add_with(const Pass& pass, Progress& progress, const std::function<bool()>& stop) {
    const std::vector<int> wanted = gathered_.allocation.samples(pass.samples, parts_);
    std::vector<NonFinite> non_finite(parts_.size());
    tbb::enumerable_thread_specific<Wave<F, RayTracer>> waves(
        [&] { return Wave<F, RayTracer>(tracer_, options_); });
    std::atomic<bool> stopped = false;
    tbb::parallel_for(std::size_t(0), parts_.size(), [&](std::size_t i) {
        const int has = samples_of(parts_[i]);
        if (has >= wanted[i]) return;
        if (stopped || stop()) {
            stopped = true;
            return;
        }
        const Tiles::Bounds& bounds = parts_[i].bounds;
        non_finite[i] =
            add_part<F>(i, {has, wanted[i], pass.group, bounds.top, bounds.bottom}, waves.local());
        progress.advance(std::uint64_t(wanted[i] - has) * std::uint64_t(parts_[i].pixels()));
    });
    for (const NonFinite& found : non_finite) {
        gathered_.non_finite.samples += found.samples;
        if (found.first) set_if_earlier(gathered_.non_finite.first, *found.first);
    }
    return !stopped;
}

template <Effects F>
NonFinite Passes::add_part(std::size_t part, const Range& range, Wave<F, RayTracer>& wave) {
    NonFinite non_finite;
    const int rows = rows_a_wave(parts_[part]);
    for (int top = range.top; top < range.bottom; top += rows) {
        const int bottom = std::min(top + rows, range.bottom);
        for (int first = range.first; first < range.last; first += Sampler::batch_size) {
            const int last = std::min(first + Sampler::batch_size, range.last);
            add_wave<F>(parts_[part], {first, last, range.group, top, bottom}, wave, non_finite);
            gathered_.rays[part] += wave.rays();
        }
    }
    return non_finite;
}

template <Effects F>
void Passes::add_wave(const Tiles::Part& part, const Range& range, Wave<F, RayTracer>& wave,
                      NonFinite& non_finite) {
    static_assert(Sampler::batch_size <= lane_count);
    SamplerLanes samplers;
    RayLanes rays;
    part.for_each_pixel(range.top, range.bottom, [&](const glm::ivec2& at) {
        const std::uint64_t key = pixel_key(seed_, at.x, at.y);
        rays.count = 0;
        for (int sample = range.first; sample < range.last; ++sample) {
            samplers.set(rays.count++, Sampler(key, sample));
        }
        aim_camera(camera_rays_, at, samplers, rays);
        for (std::size_t i = 0; i < rays.count; ++i) wave.start(rays[i], samplers[i]);
    });
    std::span<const Path> paths = wave.follow();
    const auto samples = static_cast<std::size_t>(range.last - range.first);
    part.for_each_pixel(range.top, range.bottom, [&](const glm::ivec2& at) {
        add_to_pixel(range.group, paths.first(samples), at, non_finite);
        paths = paths.subspan(samples);
    });
}

void Passes::add_to_pixel(int group_size, std::span<const Path> paths, const glm::ivec2& at,
                          NonFinite& non_finite) {
    const Camera& camera = tracer_.world().camera;
    PixelEstimate& pixel =
        gathered_.pixels[std::size_t(at.y) * std::size_t(camera.width) + std::size_t(at.x)];
    const bool counted_singly = pixel.groups > 1 && pixel.groups == pixel.sums.samples;
    if (group_size > 1 && counted_singly) pixel.join_groups();
    SampleSums group;
    for (const Path& path : paths) {
        group.add(path, camera.eye, forward_);
        if (!is_finite(path.direct + path.indirect)) {
            ++non_finite.samples;
            set_if_earlier(non_finite.first, at);
        }
        if (group_size > 1) continue;
        pixel.add_group(group);
        group = {};
    }
    if (group_size > 1) pixel.add_group(group);
}

}  // namespace plumbline::pathtracer
