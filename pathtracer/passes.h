// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "pathtracer/estimate.h"
#include "pathtracer/render.h"
#include "pathtracer/tiles.h"
#include "pathtracer/wave.h"
#include "scenes/camera_rays.h"
#include "scenes/effects.h"
#include "scenes/progress.h"

namespace plumbline::pathtracer {

/// The samples [first, last) of every pixel, `group` of them at a time as one group of
/// PixelEstimate: Sampler::batch_size, or 1.
struct Pass {
    int first;
    int last;
    int group;
};

/// All that passes have gathered.
struct Gathered {
    std::vector<PixelEstimate> pixels;  ///< row by row from the top left
    NonFinite non_finite;
    std::uint64_t rays = 0;
};

/// A picture in the making, or the tiles of one shard of it.
///
/// Its content depends on the passes done alone, not on threads or the time they took.
class Passes {
 public:
    /// `tracer` must outlive it; `effects` must cover those of its scene.
    Passes(const RayTracer& tracer, Effects effects, const PathOptions& options, std::uint64_t seed,
           const Shard& shard = {});

    /// Adds the samples of `pass` to every pixel of the shard's tiles on all threads that oneTBB
    /// has here. Tiles that have them are left alone. Takes no further tile once `stop`, which is
    /// called by all threads, has answered true; returns whether all tiles now have the samples.
    bool add(
        const Pass& pass, Progress& progress,
        const std::function<bool()>& stop = [] { return false; });

    /// Steps of `progress` that a pass takes: one for each tile that lacks its samples.
    std::uint64_t tiles() const { return tiles_.size(); }
    /// Samples that every pixel of the shard has.
    int samples() const;
    /// No tile has more samples than another.
    bool between_passes() const;

    const Gathered& gathered() const { return gathered_; }
    const std::vector<PixelEstimate>& pixels() const { return gathered_.pixels; }
    const NonFinite& non_finite() const { return gathered_.non_finite; }
    std::uint64_t rays() const { return gathered_.rays; }
    /// A pixel of the shard; all have as many groups between passes.
    const PixelEstimate& first_pixel() const { return first_of(tiles_.front()); }

    /// Goes on from what equal passes over the same scene and shard gathered.
    void restore(Gathered gathered) { gathered_ = std::move(gathered); }

 private:
    struct TileCounts;

    const PixelEstimate& first_of(int tile) const;

    template <Effects F>
    bool add_with(const Pass& pass, Progress& progress, const std::function<bool()>& stop);
    template <Effects F>
    TileCounts add_tile(const Pass& pass, int tile, Wave<F, RayTracer>& wave);
    template <Effects F>
    void add_wave(const Pass& pass, const Tiles::Bounds& block, Wave<F, RayTracer>& wave,
                  TileCounts& counts);
    void add_to_pixel(const Pass& pass, std::span<const Path> paths, const glm::ivec2& at,
                      TileCounts& counts);

    const RayTracer& tracer_;
    Effects effects_;
    std::unique_ptr<const Emitters> emitters_;           ///< null unless the effects aim at them
    std::unique_ptr<const EnvironmentMap> environment_;  ///< null without a picture of it
    std::unique_ptr<const LightChoice> lights_;          ///< null unless the effects choose
    PathOptions options_;
    std::uint64_t seed_;
    CameraRays camera_rays_;
    glm::vec3 forward_;
    Tiles all_tiles_;
    std::vector<int> tiles_;  // of the shard
    Gathered gathered_;
};

}  // namespace plumbline::pathtracer
