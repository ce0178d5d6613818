// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "pathtracer/closed_forms.h"

namespace plumbline::pathtracer {

/// A closed form against what the kernel that its scene calls for makes of it.
struct Measured {
    double radiance = 0.;        ///< mean of the first channel
    double standard_error = 0.;  ///< of the mean
    double z = 0.;               ///< deviation in standard errors; rounding is taken off it first
    int kernels = 0;             ///< how many kernels cover the scene's effects
    bool same_bits = true;       ///< all of these give the same bits
};
Measured measure(const ClosedForm& form, int batches);

/// A statistic that right code keeps within `limit`.
struct Finding {
    std::string name;
    std::string of;  ///< what it is the statistic of
    double z;
    double limit;

    bool holds() const { return !(std::abs(z) > limit) && !std::isnan(z); }
};

/// Pixel by pixel, estimates that must agree in the mean: the largest deviation of all pixels and
/// channels, with the variances of both [Sidak 1967].
std::vector<Finding> agreements();

/// Samplers against their densities: chi-square as a standard normal deviate.
std::vector<Finding> distributions();

}  // namespace plumbline::pathtracer
