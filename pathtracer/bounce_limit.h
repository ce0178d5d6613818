// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "pathtracer/render.h"
#include "scenes/effects.h"
#include "scenes/world.h"

namespace plumbline::pathtracer {

/// After how many indirect bounces paths of a render stop, and why, in plain words.
struct BounceLimit {
    std::optional<int> max_bounces;  ///< none: where Russian roulette ends them
    std::string why;
};

/// What `options` ask for; or, where they ask for an error and no number of bounces, the fewest
/// bounces past which it is proven that all light together is too little to count.
///
/// The bound, for each channel: let rho be the largest albedo, E the sum of what each light brings
/// at normal incidence to the surface nearest to it, and L the largest radiance that arrives from
/// emitters and the environment. A Lambert surface then shows R_1 <= rho (E / pi + L) of light
/// scattered once, and R_n <= rho R_(n-1) of light scattered n times, since it averages what
/// arrives. What is scattered more than m times is a geometric series below
/// rho^m R_1 / (1 - rho) = R. It takes at most R^2 / 0.01 from relMSE, by relMSE's definition
/// d^2 / (ref^2 + 0.01). Paths stop where that is below a hundredth of the relMSE asked for: a bias
/// of at most a tenth of the error, in RMSE's terms.
BounceLimit bounce_limit(const World& world, Effects effects, const RenderOptions& options);

}  // namespace plumbline::pathtracer
