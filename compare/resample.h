// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenes/image.h"

namespace plumbline::compare {

/// The image at another size, by a triangle filter as wide as the larger of both pixels: it neither
/// rings nor makes negative light, and a constant stays constant.
///
/// Layers whose values mean nothing once they are mixed are dropped: `object`, `samples` and
/// variances, since the noise of neighbouring pixels is no longer independent.
/// Throws ImageError if the library fails.
Image resampled(const Image& image, int width, int height);

}  // namespace plumbline::compare
