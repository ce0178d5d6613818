// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cassert>
#include <span>
#include <type_traits>

#include "ddgi/grid.h"

namespace plumbline::ddgi {

/// What constants are held in that multiply a T: float in the renderer, double beside dual numbers.
template <typename T>
using Coefficient = std::conditional_t<std::is_same_v<T, float>, float, double>;

/// Bins are summed this many at a time, side by side in vector registers.
constexpr std::size_t bins_at_once = 8;

/// Where a value lies among what all probes hold: `bins` values a probe and colour channel, the
/// bins that a look-up sums side by side.
constexpr std::size_t value_index(std::size_t probe, std::size_t channel, std::size_t bin,
                                  std::size_t bins) {
    return (probe * 3 + channel) * bins + bin;
}

/// sum_p w_p sum_b values[p][b] response[b] per channel, over the probes p around a point.
///
/// `response` says how much of each bin (a direction that a probe keeps apart) counts for the
/// surface's normal; its size is the number of bins, a multiple of bins_at_once.
/// T is float in the renderer, a dual number in a fit.
template <typename T>
std::array<T, 3> look_up(const ProbeNeighbours& around, std::span<const float> response,
                         std::span<const T> values) {
    const std::size_t bins = response.size();
    assert(bins % bins_at_once == 0);
    std::array<T, 3> result{T(0), T(0), T(0)};
    for (std::size_t channel = 0; channel < 3; ++channel) {
        for (std::size_t first = 0; first < bins; first += bins_at_once) {
            std::array<T, bins_at_once> blend;
            blend.fill(T(0));
            for (std::size_t corner = 0; corner < around.probe.size(); ++corner) {
                const Coefficient<T> weight = around.weight[corner];
                const T* probe = &values[value_index(around.probe[corner], channel, first, bins)];
                for (std::size_t i = 0; i < bins_at_once; ++i) blend[i] += weight * probe[i];
            }
            for (std::size_t i = 0; i < bins_at_once; ++i) {
                result[channel] += Coefficient<T>(response[first + i]) * blend[i];
            }
        }
    }
    return result;
}

}  // namespace plumbline::ddgi
