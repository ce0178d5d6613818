// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "compare/metrics.h"

namespace plumbline::compare {

/// The error of the pixels that show one object.
struct ObjectError {
    long object;  ///< its number in the layer `object`
    std::size_t pixels;
    Metrics metrics;  ///< without ssim; flip is the mean of the map over the pixels
    double share;     ///< of the picture's sum of squared errors
};

/// The error of each object, the one with the largest share first. Empty if neither image has a
/// layer `object`; the reference's is taken if both have. `flip_map`: one value a pixel, or empty.
std::vector<ObjectError> errors_by_object(const Image& reference, const Image& test,
                                          const LayerPair& pair, std::span<const float> flip_map);

/// The error e = sqrt(mean over channels of (t - r)^2) of pixels, in their order.
struct ErrorPercentile {
    double percent;
    double error;        ///< this percentage of pixels have at most this e
    double share_above;  ///< of the sum of e^2, held by the pixels above: near 1 at 99 percent, one
                         ///< pixel in a hundred makes up the error
};

/// The curve at 1, 5, 10, 25, 50, 75, 90, 95, 99, 99.9 and 100 percent.
std::vector<ErrorPercentile> error_percentiles(const LayerPair& pair);

}  // namespace plumbline::compare
