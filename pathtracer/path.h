// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>

#include "scenes/ray_tracer.h"

namespace plumbline::pathtracer {

/// Which paths are followed, and how far.
struct PathOptions {
    int max_scatterings = std::numeric_limits<int>::max();
    /// Ends paths at random; without it, every path runs to max_scatterings or out of the scene.
    bool roulette = true;
    /// Scatterings before roulette may end a path. This and `sure_throughput` gave the lowest
    /// variance times rays of many settings tried on the library's cornell-box and room-with-door.
    int roulette_start = 5;
    /// Throughput below which roulette becomes likelier to end a path the less it carries.
    float sure_throughput = .25f;
};

/// One path's estimate of the radiance along a camera ray, W m^-2 sr^-1, split by how often the
/// light was scattered on its way, and the first surface met.
struct Path {
    Spectrum direct{0.f};    ///< scattered once at most
    Spectrum bounce1{0.f};   ///< scattered twice
    Spectrum indirect{0.f};  ///< scattered twice or more
    std::optional<Hit> surface;
    unsigned rays = 0;  ///< camera, bounce and shadow rays

    void add(int scatterings, const Spectrum& L) {
        if (scatterings <= 1) {
            direct += L;
            return;
        }
        indirect += L;
        if (scatterings == 2) bounce1 += L;
    }
};

}  // namespace plumbline::pathtracer
