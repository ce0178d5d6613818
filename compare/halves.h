// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "compare/noise.h"

namespace plumbline::compare {

/// Second pictures of the same thing with independent noise, as another seed gives; either may be
/// null.
struct Halves {
    const Image* reference = nullptr;
    const Image* test = nullptr;

    bool any() const { return reference || test; }
};

/// What halves tell: the split, and the variance of d per pixel, from its surroundings.
struct HalvesSplit {
    NoiseSplit split;
    std::array<std::vector<float>, 3> variance;
};

/// Splits the error by halves instead of variances.
///
/// With d1 = t1 - r1 and d2 = t2 - r2 (an image without a half stands in both), noise that the two
/// do not share cancels in the mean of d1 d2, which so estimates the mean of b^2 without bias; s^2,
/// its variance, is (d1 - d2)^2 / 2. With u = (d1 + d2)/2 and v = d1 - d2, independent of each
/// other, Var(d1 d2) is the mean of (u v)^2, for a pixel of (sum over channels u v)^2, so the
/// interval's V is the sum of that over pixels. Noise of an image without a half but with variances
/// s_0^2 is shared: it is taken off d1 d2, and V adds 4 rho s_0 s_0' d1 d2' - 2 rho^2 s_0^2 s_0'^2
/// as in NoiseSplit.
///
/// z needs s of the single pixel, which one difference cannot give: the mean over the 9 x 9
/// pixels around it is taken [Rousselle et al. 2012].
/// Throws ImageError if sizes differ, the layer is missing, or two of the pictures and
/// halves share samples.
HalvesSplit split_by_halves(const Image& reference, const Image& test, const Halves& halves,
                            const LayerPair& pair);

}  // namespace plumbline::compare
