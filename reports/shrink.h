// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "scenes/image.h"

namespace plumbline::reports {

/// How many blocks of `block` cover `size` pixels.
inline int blocks(int size, int block) { return (size + block - 1) / block; }

/// Means of blocks of `block` x `block` pixels, smaller at the right and bottom edge.
std::vector<float> block_means(std::span<const float> plane, int width, int height, int block);

/// The layers of a picture that a page shows (radiance, indirect, and their variances of the mean
/// where there are any) at 1/`block` of its size. Variances of block means take pixels as
/// independent.
Image shrunk(const Image& image, int block);

}  // namespace plumbline::reports
