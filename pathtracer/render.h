// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>

#include "pathtracer/tiles.h"
#include "scenes/image.h"
#include "scenes/scene.h"

namespace plumbline::pathtracer {

/// Up to this many bounces asked for, roulette would save little and add noise.
inline constexpr int longest_without_roulette = 16;

/// When to stop, and which paths to follow.
struct RenderOptions {
    int spp = 64;                           ///< samples a pixel; an upper bound with the next two
    std::optional<double> seconds{};        ///< stop after this much wall-clock time
    std::optional<double> target_relmse{};  ///< stop when relmse_estimate falls to this
    /// Indirect bounces; none: until Russian roulette, or with a target until a bound proves the
    /// rest too dark. Paths asked to have at most `longest_without_roulette` are all followed to
    /// their end.
    std::optional<int> max_bounces{};
    std::uint64_t seed = 0;
    Shard shard{};  ///< of one of several renders of `spp` samples, to be merged
    /// Shares the samples after a pilot out, where the error falls most for the rays that it takes
    /// (see Allocation); `spp` is then their mean.
    bool adaptive = false;
};

/// How a long render outlives its process.
struct CheckpointOptions {
    std::filesystem::path file;  ///< to keep it in while it goes on
    double every_seconds = 60.;  ///< or less often, so that writing takes 5 % of the time at most
    bool resume = false;         ///< go on from `file` if it is there; else it must not be there
    std::function<bool()> interrupted = [] { return false; };  ///< called by all threads
    /// Told what keeps the file from being written; the render goes on, and tries again later.
    std::function<void(const std::string& line)> not_written = [](const std::string&) {};
};

/// Samples whose radiance is not finite. They are kept, so that their pixels show it.
struct NonFinite {
    std::uint64_t samples = 0;
    std::optional<glm::ivec2> first;  ///< x, y of the first such pixel, row by row from the top
};

/// Samples a pixel, over the pixels of the picture or of its shard.
struct SampleCounts {
    double mean = 0.;
    std::uint32_t fewest = 0;
    std::uint32_t most = 0;
};

/// A finished picture with the layers that the README lists, and what it took.
struct RenderResult {
    Image image;
    int spp;  ///< those of the last whole pass; the mean if adaptive, to a batch of one half-tile
    double seconds;
    std::uint64_t rays;  ///< camera, bounce and shadow rays
    /// Of the radiance layer, from its variance of the mean: see relmse_estimate(). NaN with one
    /// sample a pixel, which cannot tell; the picture then has no variance layers.
    double relmse_estimate;
    NonFinite non_finite;
    SampleCounts counts;
};

/// Renders one frame of the scene; same seed, same pixels, whatever the threads.
///
/// Samples are added 16 a pixel at a time, over the whole picture. With `seconds` or
/// `target_relmse`, the first 16 always, then as long as the time for 16 more is left and the
/// target is not reached. A shard's picture has samples in its own tiles alone, and zeros
/// elsewhere. Throws UsageError if a shard, or `adaptive`, is not possible with the other options.
RenderResult render(const Scene& scene, int frame, const RenderOptions& options);

/// The same, with checkpoints: killed at any moment and resumed it gives the same pixels, and
/// counts the seconds before. None if `interrupted` ended it; `file` then holds all that is done.
/// Throws UsageError if `file` is there without `resume`, ImageError if it does not fit.
std::optional<RenderResult> render(const Scene& scene, int frame, const RenderOptions& options,
                                   const CheckpointOptions& checkpoints);

}  // namespace plumbline::pathtracer
