// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/layer_pair.h"

namespace plumbline::compare {

/// The error that is left when both pictures are averaged over square blocks.
struct ScaleError {
    int width;               ///< of a block, pixels
    double rmse;             ///< of the means of d over blocks and channels
    double if_noise;         ///< what rmse would be here if the error were independent per pixel
    std::size_t blocks = 0;  ///< that were counted
};

/// The error at block widths 1, 2, 4 ... 64, as far as a whole block fits.
///
/// Independent noise halves with each doubling; a plateau is bias or structure that per-pixel
/// figures hide. Only whole blocks count; a pixel that is not finite, or outside a mask, is left
/// out of its block: the mean of the n others has the variance sum d^2 / n^2 if they are noise.
std::vector<ScaleError> error_by_scale(const LayerPair& pair);

/// The slope of log2(rmse) against log2(width), least squares: -1 for independent noise, 0 for a
/// constant bias. None with fewer than two widths or an error of zero.
std::optional<double> scale_slope(const std::vector<ScaleError>& errors);

/// What the widest blocks say, in words: "noise", or "structure or bias" where their error is above
/// what independent noise would leave there, or "errors that cancel" where it is below, each with
/// the figure. Above and below: by more than three standard errors, 1 / sqrt(2 n) of n independent
/// blocks whose channels are taken as one; widths of which fewer than eight fit are not judged.
std::string scale_verdict(const std::vector<ScaleError>& errors);

}  // namespace plumbline::compare
