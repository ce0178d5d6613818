// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "compare/layer_pair.h"
#include "compare/tone_mapper.h"

namespace plumbline::compare {

/// How a viewer looks at the pictures.
struct FlipOptions {
    /// Of a 0.7 m wide screen of 3840 pixels from 0.7 m away: the authors' default.
    double pixels_per_degree = 67.02064327658226;
    ToneMapper tone_mapper = ToneMapper::Aces;  ///< HDR only
    /// HDR only, in stops; none: from the reference, as hdr_flip says.
    std::optional<double> start_exposure;
    std::optional<double> stop_exposure;
};

/// A FLIP error map and its mean.
struct FlipResult {
    double mean;                ///< over usable pixels, in [0,1]; 0 for equal pictures
    std::vector<float> map;     ///< one a pixel, in [0,1]; 0 where a pixel is not finite
    double start_exposure = 0;  ///< in stops; HDR only
    double stop_exposure = 0;
    int exposures = 1;
};

/// LDR-FLIP of linear values, clamped to [0,1] [Andersson et al. 2020]:
///
/// 1. Linear sRGB to YCxCz; each channel filtered by the eye's contrast sensitivity, a Gaussian
///    a sqrt(pi/b) exp(-pi^2 x^2 / b), x in degrees: (a, b) = (1, 0.0047) for Y, (1, 0.0053) for
///    Cx, the sum of (34.1, 0.04) and (13.5, 0.025) for Cz; then clamped to [0,1] in linear RGB.
/// 2. To Hunt-adjusted CIELAB; HyAB distance to the power 0.7; below 0.4 of the largest distance
///    (green to blue) mapped linearly to [0, 0.95], above it to [0.95, 1]: the colour error c.
/// 3. Edges and points of Y by first and second derivatives of a Gaussian of standard deviation
///    0.041 degrees; f = sqrt(max(|edge_r - edge_t|, |point_r - point_t|) / sqrt(2)).
/// 4. The error is c^(1 - f). Borders repeat. A pixel that is not finite is black in both.
FlipResult ldr_flip(const LayerPair& pair, const FlipOptions& options = {});

/// HDR-FLIP: the largest LDR-FLIP over exposures, by default with the ACES tone mapper of the
/// authors [Andersson et al. 2021].
///
/// The exposures run from log2(x / largest) to log2(x / median luminance of the reference), where
/// x is tone-mapped to 0.85, in max(2, ceil(stop - start)) even steps. Where the median is not
/// positive, and the authors' stop exposure is infinite, the median of the positive luminances
/// takes its place. None if no luminance of the reference is positive.
/// Throws UsageError if the stop is before the start.
std::optional<FlipResult> hdr_flip(const LayerPair& pair, const FlipOptions& options = {});

}  // namespace plumbline::compare
