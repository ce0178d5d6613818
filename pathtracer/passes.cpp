// SPDX-License-Identifier: Apache-2.0
#include "pathtracer/passes.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "pathtracer/kernels.h"

namespace plumbline::pathtracer {
namespace {

/// Small enough to share out evenly, large enough that neighbouring rays share the cache.
constexpr int tile_size = 16;

/// With a batch of samples a pixel, a wave is large enough to fill packets of rays for many bounces
/// and small enough for the second-level cache.
constexpr int rows_a_wave = 4;

int tiles_along(int pixels) { return (pixels + tile_size - 1) / tile_size; }

bool is_finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Calls `f` with the template argument of the smallest kernel there is for `effects`.
template <std::size_t kernel = 0, typename Function>
void with_effects(Effects effects, const Function& f) {
    if constexpr (kernel < kernels.size()) {
        constexpr Effects F = kernels[kernel];
        if (covers(F, effects)) return f.template operator()<F>();
        with_effects<kernel + 1>(effects, f);
    } else {
        assert(!"an effect that the path tracer has no kernel for");
    }
}

}  // namespace

/// Pixels whose samples are traced together.
struct Passes::Block {
    int left, top, right, bottom;
};

struct Passes::TileCounts {
    std::uint64_t rays = 0;
    NonFinite non_finite;
};

Passes::Passes(const RayTracer& tracer, Effects effects, const PathOptions& options,
               std::uint64_t seed)
    : tracer_(tracer),
      effects_(effects),
      emitters_(has(effects, Effect::EmitterSampling) ? new Emitters(tracer.world()) : nullptr),
      options_(options),
      seed_(seed),
      camera_rays_(tracer.world().camera),
      forward_(glm::normalize(tracer.world().camera.target - tracer.world().camera.eye)) {
    const Camera& camera = tracer.world().camera;
    if (emitters_ && !emitters_->empty()) options_.emitters = emitters_.get();
    pixels_.resize(std::size_t(camera.width) * std::size_t(camera.height));
}

std::uint64_t Passes::tiles() const {
    const Camera& camera = tracer_.world().camera;
    return std::uint64_t(tiles_along(camera.width)) * std::uint64_t(tiles_along(camera.height));
}

void Passes::add(const Pass& pass, Progress& progress) {
    with_effects(effects_, [&]<Effects F>() { add_with<F>(pass, progress); });
}

template <Effects F>
void Passes::add_with(const Pass& pass, Progress& progress) {
    std::vector<TileCounts> counts(tiles());
    tbb::parallel_for(std::size_t(0), counts.size(), [&](std::size_t tile) {
        counts[tile] = add_tile<F>(pass, static_cast<int>(tile));
        progress.advance();
    });
    const auto row_major = [](const glm::ivec2& p) { return std::pair(p.y, p.x); };
    for (const TileCounts& tile : counts) {
        rays_ += tile.rays;
        non_finite_.samples += tile.non_finite.samples;
        const auto& found = tile.non_finite.first;
        if (found && (!non_finite_.first || row_major(*found) < row_major(*non_finite_.first))) {
            non_finite_.first = found;
        }
    }
}

template <Effects F>
Passes::TileCounts Passes::add_tile(const Pass& pass, int tile) {
    const Camera& camera = tracer_.world().camera;
    const int tiles_x = tiles_along(camera.width);
    const int left = tile % tiles_x * tile_size;
    const int top = tile / tiles_x * tile_size;
    const int right = std::min(left + tile_size, camera.width);
    const int bottom = std::min(top + tile_size, camera.height);
    TileCounts counts;
    Wave<F, RayTracer> wave(tracer_, options_);
    for (int y = top; y < bottom; y += rows_a_wave) {
        const Block block{left, y, right, std::min(y + rows_a_wave, bottom)};
        for (int first = pass.first; first < pass.last; first += Sampler::batch_size) {
            const int last = std::min(first + Sampler::batch_size, pass.last);
            add_wave<F>({first, last, pass.group}, block, wave, counts);
        }
    }
    return counts;
}

template <Effects F>
void Passes::add_wave(const Pass& pass, const Block& block, Wave<F, RayTracer>& wave,
                      TileCounts& counts) {
    for (int y = block.top; y < block.bottom; ++y) {
        for (int x = block.left; x < block.right; ++x) {
            const std::uint64_t key = pixel_key(seed_, x, y);
            for (int sample = pass.first; sample < pass.last; ++sample) {
                Sampler sampler(key, sample);
                const glm::vec2 at = glm::vec2(x, y) + sampler.next_2d();
                wave.start(camera_rays_.through(at.x, at.y), sampler);
            }
        }
    }
    std::span<const Path> paths = wave.follow();
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
        pixels_[std::size_t(at.y) * std::size_t(camera.width) + std::size_t(at.x)];
    const bool counted_singly = pixel.groups > 1 && pixel.groups == pixel.sums.samples;
    if (pass.group > 1 && counted_singly) pixel.join_groups();
    SampleSums group;
    for (const Path& path : paths) {
        group.add(path, camera.eye, forward_);
        counts.rays += path.rays;
        if (!is_finite(path.direct + path.indirect)) {
            ++counts.non_finite.samples;
            if (!counts.non_finite.first) counts.non_finite.first = at;
        }
        if (pass.group > 1) continue;
        pixel.add_group(group);
        group = {};
    }
    if (pass.group > 1) pixel.add_group(group);
}

}  // namespace plumbline::pathtracer
