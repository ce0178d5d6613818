// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

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
    /// Indirect bounces; none: until Russian roulette. Paths of at most `longest_without_roulette`
    /// bounces are all followed to their end.
    std::optional<int> max_bounces{};
    std::uint64_t seed = 0;
};

/// Samples whose radiance is not finite. They are kept, so that their pixels show it.
struct NonFinite {
    std::uint64_t samples = 0;
    std::optional<glm::ivec2> first;  ///< x, y of the first such pixel, row by row from the top
};

/// A finished picture with the layers that the README lists, and what it took.
struct RenderResult {
    Image image;
    int spp;
    double seconds;
    std::uint64_t rays;  ///< camera, bounce and shadow rays
    /// Of the radiance layer, from its variance of the mean: see relmse_estimate(). NaN with one
    /// sample a pixel, which cannot tell; the picture then has no variance layers.
    double relmse_estimate;
    NonFinite non_finite;
};

/// Renders one frame of the scene; same seed, same pixels, whatever the threads.
///
/// With `seconds` or `target_relmse`, samples are added 16 a pixel at a time, over the whole
/// picture: the first 16 always, then as long as the time for 16 more is left and the target is not
/// reached.
RenderResult render(const Scene& scene, int frame, const RenderOptions& options);

}  // namespace plumbline::pathtracer
