// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "pathtracer/allocation.h"
#include "pathtracer/estimate.h"
#include "pathtracer/render.h"
#include "pathtracer/tiles.h"
#include "pathtracer/wave.h"
#include "scenes/camera_rays.h"
#include "scenes/effects.h"
#include "scenes/progress.h"

namespace plumbline::pathtracer {

/// Samples up to `samples` a pixel, on average once an allocation shares them out; `group` of them
/// at a time count as one group of PixelEstimate: Sampler::batch_size, or 1.
struct Pass {
    int samples;
    int group;
};

/// Whether all pixels get as many samples, or what is gathered may be asked to share_out().
enum class Sampling { Even, Adaptive };

/// All that passes have gathered.
struct Gathered {
    std::vector<PixelEstimate> pixels;  ///< row by row from the top left
    NonFinite non_finite;
    std::vector<std::uint64_t> rays;  ///< of each part
    int samples = 0;                  ///< those of the last whole pass
    Allocation allocation;
};

/// A picture in the making, or the tiles of one shard of it. Its parts are the units of work:
/// tiles, or half-tiles if it is adaptive.
///
/// Its content depends on the passes done alone, not on threads or the time they took.
class Passes {
 public:
    /// `tracer` must outlive it; `effects` must cover those of its scene.
    Passes(const RayTracer& tracer, Effects effects, const PathOptions& options, std::uint64_t seed,
           const Shard& shard = {}, Sampling sampling = Sampling::Even);

    /// Adds to every part of the picture what it lacks of the samples of `pass`, on all threads
    /// that oneTBB has here. Takes no further one once `stop`, which is called by all threads, has
    /// answered true; returns whether all now have the samples.
    bool add(
        const Pass& pass, Progress& progress,
        const std::function<bool()>& stop = [] { return false; });

    /// Shares out the samples from now on by what all so far have shown, two whole groups a pixel
    /// at least: see Allocation. Does nothing the second time.
    void share_out();

    /// Steps of `progress` up to `samples` a pixel: one for each sample of each pixel of the shard.
    std::uint64_t steps(int samples) const;
    /// Samples that every pixel of the shard has from whole passes, on average.
    int samples() const { return gathered_.samples; }
    /// No part has samples of a pass that others lack.
    bool between_passes() const;
    /// Rays that it will take to get to `samples`, as far as those so far can tell.
    double rays_to(int samples) const;

    const Gathered& gathered() const { return gathered_; }
    const std::vector<PixelEstimate>& pixels() const { return gathered_.pixels; }
    const NonFinite& non_finite() const { return gathered_.non_finite; }
    std::uint64_t rays() const;
    /// A pixel of the shard.
    const PixelEstimate& first_pixel() const { return first_of(parts_.front()); }

    /// Goes on from what equal passes over the same scene and shard gathered.
    void restore(Gathered gathered) { gathered_ = std::move(gathered); }

 private:
    struct Range;

    const PixelEstimate& pixel(const glm::ivec2& at) const;
    /// All of a part have as many samples.
    const PixelEstimate& first_of(const Tiles::Part& part) const;
    int samples_of(const Tiles::Part& part) const {
        return static_cast<int>(first_of(part).sums.samples);
    }

    template <Effects F>
    bool add_with(const Pass& pass, Progress& progress, const std::function<bool()>& stop);
    template <Effects F>
    NonFinite add_part(std::size_t part, const Range& range, Wave<F, RayTracer>& wave);
    template <Effects F>
    void add_wave(const Tiles::Part& part, const Range& range, Wave<F, RayTracer>& wave,
                  NonFinite& non_finite);
    void add_to_pixel(int group, std::span<const Path> paths, const glm::ivec2& at,
                      NonFinite& non_finite);

    const RayTracer& tracer_;
    Effects effects_;
    std::unique_ptr<const Emitters> emitters_;           ///< null unless the effects aim at them
    std::unique_ptr<const EnvironmentMap> environment_;  ///< null without a picture of it
    std::unique_ptr<const LightChoice> lights_;          ///< null unless the effects choose
    PathOptions options_;
    std::uint64_t seed_;
    CameraRays camera_rays_;
    glm::vec3 forward_;
    std::vector<Tiles::Part> parts_;
    Gathered gathered_;
};

}  // namespace plumbline::pathtracer
