// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "pathtracer/estimate.h"
#include "pathtracer/render.h"
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

/// A picture in the making: all that is known of each pixel, row by row from the top left.
///
/// Its content depends on the passes done alone, not on threads or the time they took.
class Passes {
 public:
    /// `tracer` must outlive it; `effects` must cover those of its scene.
    Passes(const RayTracer& tracer, Effects effects, const PathOptions& options,
           std::uint64_t seed);

    /// Adds the samples of `pass` to every pixel on all threads that oneTBB has here.
    void add(const Pass& pass, Progress& progress);

    /// Steps of `progress` that a pass takes.
    std::uint64_t tiles() const;

    const std::vector<PixelEstimate>& pixels() const { return pixels_; }
    const NonFinite& non_finite() const { return non_finite_; }
    std::uint64_t rays() const { return rays_; }

 private:
    struct TileCounts;
    struct Block;

    template <Effects F>
    void add_with(const Pass& pass, Progress& progress);
    template <Effects F>
    TileCounts add_tile(const Pass& pass, int tile);
    template <Effects F>
    void add_wave(const Pass& pass, const Block& block, Wave<F, RayTracer>& wave,
                  TileCounts& counts);
    void add_to_pixel(const Pass& pass, std::span<const Path> paths, const glm::ivec2& at,
                      TileCounts& counts);

    const RayTracer& tracer_;
    Effects effects_;
    std::unique_ptr<const Emitters> emitters_;  ///< null unless the effects aim at them
    PathOptions options_;
    std::uint64_t seed_;
    CameraRays camera_rays_;
    glm::vec3 forward_;
    std::vector<PixelEstimate> pixels_;
    NonFinite non_finite_;
    std::uint64_t rays_ = 0;
};

}  // namespace plumbline::pathtracer
