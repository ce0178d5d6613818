// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "pathtracer/path_options.h"
#include "scenes/ray_tracer.h"

namespace plumbline::pathtracer {

/// One path's estimate of the radiance along a camera ray, W m^-2 sr^-1, split by how often the
/// light was scattered on its way, and the first surface met.
struct Path {
    Spectrum direct{0.f};    ///< scattered once at most
    Spectrum bounce1{0.f};   ///< scattered twice
    Spectrum indirect{0.f};  ///< scattered twice or more
    std::optional<Hit> surface;

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
