// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pathtracer/estimate.h"
#include "pathtracer/tiles.h"

namespace plumbline::pathtracer {

/// Fewest samples a pixel that leave something to share out.
inline constexpr int fewest_to_allocate = 48;

/// Samples that every pixel gets before the rest of `spp` is shared out: a quarter, in whole
/// batches, between 2 batches, the fewest that tell a variance, and 4.
int pilot_samples(int spp);

/// How the samples after a pilot are shared out among half-tiles: where the error falls most for
/// the rays that it takes.
///
/// Each half's share is decided once, by the pilot of the other half of its tile, and all of one
/// colour are measured against each other alone. Hence the number of a pixel's samples depends on
/// pixels of the other colour only, whose samples are independent of its own: every sample counts,
/// and the mean of each pixel and its variance stay unbiased whatever was decided. Samples that
/// take part in the decision about themselves would bias it [Kirk and Arvo 1991].
struct Allocation {
    int pilot = 0;
    /// Of each half, its samples over the mean of its colour; empty: all even.
    std::vector<double> shares;

    /// Samples a pixel that each of `parts` has at `level` samples a pixel on average: `level` if
    /// even. Else they are the halves of the picture, and have whole batches, nowhere fewer than
    /// the pilot. The mean of each colour is at most `level`, and short of it by less than one
    /// batch of one half. Rises with `level`.
    std::vector<int> samples(int level, std::span<const Tiles::Part> parts) const;
};

/// What was gathered of a half-tile, as far as allocations look at it.
struct HalfCost {
    double relmse = 0.;  ///< of one sample, mean over its pixels; NaN if none is finite
    double rays = 1.;    ///< that one sample takes
};

/// `pixels` are those of a picture `width` wide; all of the half have as many samples, two groups
/// at least, which took `rays`.
HalfCost cost_of(const Tiles::Part& half, std::span<const PixelEstimate> pixels, int width,
                 std::uint64_t rays);

/// The allocation that minimises the relMSE for a number of rays: samples as the square root of
/// the relMSE of one over its rays [Neyman 1934], each half by the costs of the other. To be safe
/// from what a pilot has not seen, no share is below 1/8 of the mean or above 16 times it.
/// `costs` are those of `halves`.
Allocation allocate(int pilot, std::span<const Tiles::Part> halves,
                    std::span<const HalfCost> costs);

}  // namespace plumbline::pathtracer
