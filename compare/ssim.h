// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "compare/layer_pair.h"

namespace plumbline::compare {

/// Width of the square Gaussian window of SSIM, and its standard deviation, in pixels
/// [Wang et al. 2004, section III.C].
inline constexpr int ssim_window = 11;
inline constexpr double ssim_sigma = 1.5;

/// Mean structural similarity of two layers, 1 for equal ones [Wang et al. 2004, eq. 13].
///
///     SSIM = (2 mu_r mu_t + C1)(2 sigma_rt + C2)
///            / ((mu_r^2 + mu_t^2 + C1)(sigma_r^2 + sigma_t^2 + C2))
///
/// with C1 = (0.01 L)^2, C2 = (0.03 L)^2 and data range L = 1, on the Rec.709 luma of
/// sRGB-encoded values: SSIM was made for what a display shows, so linear values outside [0,1]
/// are shown, and measured, as 0 or 1. The mean is over windows that lie inside the picture
/// and whose middle lies inside the mask. A
/// pixel that is not finite counts as black in both. None if there is no such window.
std::optional<double> ssim(const LayerPair& pair);

}  // namespace plumbline::compare
