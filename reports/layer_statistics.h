// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "scenes/image.h"

namespace plumbline::reports {

/// Mean over pixels and channels of a layer's finite values; NaN if there are none.
double layer_mean(const Image& image, const std::string& layer);

/// Root of the mean variance of a layer ("" is radiance): the RMSE that its own noise causes in a
/// comparison. Throws ImageError if the image has no such variance.
double layer_noise(const Image& image, const std::string& layer);

/// The value that `share` of a layer's finite values do not exceed, all channels together.
/// 0 if there are none.
double layer_percentile(const Image& image, const std::string& layer, double share);

}  // namespace plumbline::reports
