// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "scenes/image.h"
#include "scenes/scene.h"

namespace plumbline::pathtracer {

/// When to stop, and which paths to follow.
struct RenderOptions {
    int spp = 64;                         ///< samples a pixel; an upper bound with the next two
    std::optional<double> seconds;        ///< stop after this much wall-clock time
    std::optional<double> target_relmse;  ///< stop when relmse_estimate falls to this
    std::optional<int> max_bounces;       ///< indirect bounces; none: until Russian roulette
    std::uint64_t seed = 0;
};

/// A finished picture with the layers that the README lists, and what it took.
struct RenderResult {
    Image image;
    int spp;
    double seconds;
    std::uint64_t rays;      ///< camera, bounce and shadow rays
    double relmse_estimate;  ///< of the radiance layer, from its variance of the mean
};

/// Renders one frame of the scene; same seed, same pixels, whatever the threads.
RenderResult render(const Scene& scene, int frame, const RenderOptions& options);

}  // namespace plumbline::pathtracer
