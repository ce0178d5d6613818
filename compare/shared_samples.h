// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/halves.h"

namespace plumbline::compare {

/// Whether both are path-traced pictures of one scene and frame with one seed, as their headers
/// say: then the samples of the one with fewer are in the other too, and their noise is not
/// independent. Pictures whose headers say nothing of that are taken to be independent.
bool share_samples(const Image& a, const Image& b);

/// Throws ImageError if any two of the pictures and halves share samples.
void check_independent(const Image& reference, const Image& test, const Halves& halves);

/// Whether the variances of a picture overstate its noise, as the header of a path-traced one with
/// too few samples for batches says.
bool variances_overstate(const Image& image);

}  // namespace plumbline::compare
