// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "ddgi/volume.h"

namespace plumbline::ddgi {

/// How fast light that only the probes themselves feed grows or dies.
struct SpectralRadius {
    double value = 0;      ///< below 1 the probes converge, at any light; above they blow up
    int updates = 0;       ///< probe updates that it took
    bool settled = false;  ///< more of them would change the value by less than 1e-5 of itself
};

/// The spectral radius of the linear part L of a model's update v -> L v + b, by power iteration.
///
/// `probes` hold `values` values. L v is the difference of two updates, so any model with surfels
/// can be asked. No entry of L is negative (light is never taken away), hence a positive start has
/// a share of the leading mode [Meyer 2000, section 8.3]. Colour channels never mix, so each is
/// iterated by itself, and the largest of the three radii counts. `mode`, one value of each that
/// the probes hold (see value_index), is where the iteration starts, and takes each channel's
/// leading mode with a largest value of 1; empty starts at ones.
///
/// Where a model clamps, as the thesis's does at a surfel's radiance of 1, L belongs to states
/// below the clamp: there the probes grow to it, and end in light that the scene does not have.
SpectralRadius spectral_radius(const ProbeModel& model, std::size_t probes, std::size_t values,
                               std::vector<float>& mode);

/// The multiBounceIntensity at which the model thesis's radius is 1 with the surfels of `volume`
/// and the other constants of `options`, to 1e-4 of the radius. None if another factor alone makes
/// the radius 1 or more, or if no intensity up to the one asked for does.
std::optional<double> critical_multi_bounce(const Scene& scene, const ProbeVolume& volume,
                                            const DdgiOptions& options);

}  // namespace plumbline::ddgi
