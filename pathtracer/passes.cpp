// SPDX-License-Identifier: Apache-2.0
#include "pathtracer/passes.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "pathtracer/kernels.h"

namespace plumbline::pathtracer {
namespace {

/// With a batch of samples a pixel, a wave is large enough to fill packets of rays for many bounces
/// and small enough for the second-level cache.
constexpr int rows_a_wave = 4;

bool is_finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Keeps the first pixel, row by row from the top, whatever the order in which they are found.
void set_if_earlier(std::optional<glm::ivec2>& first, const glm::ivec2& at) {
    if (!first || std::pair(at.y, at.x) < std::pair(first->y, first->x)) first = at;
}

}  // namespace

struct Passes::TileCounts {
    std::uint64_t rays = 0;
    NonFinite non_finite;
};

Passes::Passes(const RayTracer& tracer, Effects effects, const PathOptions& options,
               std::uint64_t seed, const Shard& shard)
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
      forward_(glm::normalize(tracer.world().camera.target - tracer.world().camera.eye)),
      all_tiles_(tracer.world().camera.width, tracer.world().camera.height),
      tiles_(all_tiles_.of(shard)) {
    const Camera& camera = tracer.world().camera;
    if (emitters_ && !emitters_->empty()) options_.emitters = emitters_.get();
    options_.environment = environment_.get();
    options_.lights = lights_.get();
    gathered_.pixels.resize(std::size_t(camera.width) * std::size_t(camera.height));
}

const PixelEstimate& Passes::first_of(int tile) const {
    const Tiles::Bounds bounds = all_tiles_.bounds(tile);
    const auto width = static_cast<std::size_t>(tracer_.world().camera.width);
    return gathered_.pixels[std::size_t(bounds.top) * width + std::size_t(bounds.left)];
}

int Passes::samples() const {
    std::uint32_t fewest = first_pixel().sums.samples;
    for (const int tile : tiles_) fewest = std::min(fewest, first_of(tile).sums.samples);
    return static_cast<int>(fewest);
}

bool Passes::between_passes() const {
    return std::all_of(tiles_.begin(), tiles_.end(), [&](int tile) {
        return first_of(tile).sums.samples == first_pixel().sums.samples;
    });
}

bool Passes::add(const Pass& pass, Progress& progress, const std::function<bool()>& stop) {
    bool complete = false;
    with_effects(effects_, [&]<Effects F>() { complete = add_with<F>(pass, progress, stop); });
    return complete;
}

template <Effects F>
bool Passes::add_with(const Pass& pass, Progress& progress, const std::function<bool()>& stop) {
    std::vector<TileCounts> counts(tiles_.size());
    tbb::enumerable_thread_specific<Wave<F, RayTracer>> waves(
        [&] { return Wave<F, RayTracer>(tracer_, options_); });
    std::atomic<bool> stopped = false;
    tbb::parallel_for(std::size_t(0), tiles_.size(), [&](std::size_t i) {
        if (first_of(tiles_[i]).sums.samples >= static_cast<std::uint32_t>(pass.last)) return;
        if (stopped || stop()) {
            stopped = true;
            return;
        }
        counts[i] = add_tile<F>(pass, tiles_[i], waves.local());
        progress.advance();
    });
    for (const TileCounts& tile : counts) {
        gathered_.rays += tile.rays;
        gathered_.non_finite.samples += tile.non_finite.samples;
        if (const auto& found = tile.non_finite.first) {
            set_if_earlier(gathered_.non_finite.first, *found);
        }
    }
    return !stopped;
}

template <Effects F>
Passes::TileCounts Passes::add_tile(const Pass& pass, int tile, Wave<F, RayTracer>& wave) {
    const Tiles::Bounds bounds = all_tiles_.bounds(tile);
    TileCounts counts;
    for (int y = bounds.top; y < bounds.bottom; y += rows_a_wave) {
        const Tiles::Bounds rows{bounds.left, y, bounds.right,
                                 std::min(y + rows_a_wave, bounds.bottom)};
        for (int first = pass.first; first < pass.last; first += Sampler::batch_size) {
            const int last = std::min(first + Sampler::batch_size, pass.last);
            add_wave<F>({first, last, pass.group}, rows, wave, counts);
        }
    }
    return counts;
}

template <Effects F>
void Passes::add_wave(const Pass& pass, const Tiles::Bounds& block, Wave<F, RayTracer>& wave,
                      TileCounts& counts) {
    static_assert(Sampler::batch_size <= lane_count);
    SamplerLanes samplers;
    RayLanes rays;
    for (int y = block.top; y < block.bottom; ++y) {
        for (int x = block.left; x < block.right; ++x) {
            const std::uint64_t key = pixel_key(seed_, x, y);
            rays.count = 0;
            for (int sample = pass.first; sample < pass.last; ++sample) {
                samplers.set(rays.count++, Sampler(key, sample));
            }
            aim_camera(camera_rays_, {x, y}, samplers, rays);
            for (std::size_t i = 0; i < rays.count; ++i) wave.start(rays[i], samplers[i]);
        }
    }
    std::span<const Path> paths = wave.follow();
    counts.rays += wave.rays();
    const auto samples = static_cast<std::size_t>(pass.last - pass.first);
    for (int y = block.top; y < block.bottom; ++y) {
        for (int x = block.left; x < block.right; ++x) {
            add_to_pixel(pass, paths.first(samples), {x, y}, counts);
            paths = paths.subspan(samples);
        }
    }
}

void Passes::add_to_pixel(const Pass& pass, std::span<const Path> paths, const glm::ivec2& at,
                          TileCounts& counts) {
    const Camera& camera = tracer_.world().camera;
    PixelEstimate& pixel =
        gathered_.pixels[std::size_t(at.y) * std::size_t(camera.width) + std::size_t(at.x)];
    const bool counted_singly = pixel.groups > 1 && pixel.groups == pixel.sums.samples;
    if (pass.group > 1 && counted_singly) pixel.join_groups();
    SampleSums group;
    for (const Path& path : paths) {
        group.add(path, camera.eye, forward_);
        if (!is_finite(path.direct + path.indirect)) {
            ++counts.non_finite.samples;
            set_if_earlier(counts.non_finite.first, at);
        }
        if (pass.group > 1) continue;
        pixel.add_group(group);
        group = {};
    }
    if (pass.group > 1) pixel.add_group(group);
}

}  // namespace plumbline::pathtracer
