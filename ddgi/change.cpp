// SPDX-License-Identifier: Apache-2.0
#include "ddgi/change.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace plumbline::ddgi {
namespace {

constexpr float darkest_of_brightest = 1e-6f;

/// The largest magnitude of value_of(i), i < count; a NaN if one is NaN. Bits of magnitudes are
/// ordered as they are, infinities and then NaNs last, and unlike floats can be compared side by
/// side.
template <typename ValueOf>
float largest_magnitude(std::size_t count, const ValueOf& value_of) {
    std::int32_t largest = 0;
    for (std::size_t i = 0; i < count; ++i) {
        largest = std::max(largest, std::bit_cast<std::int32_t>(value_of(i)) & 0x7fffffff);
    }
    return std::bit_cast<float>(largest);
}

/// Of a probe: the largest values of its state, and of how much it changed.
struct Largest {
    float value = 0.f;
    float change = 0.f;
};

}  // namespace

Change change_between(std::span<const float> previous, std::span<const float> next,
                      std::size_t per_probe) {
    std::vector<Largest> largest(next.size() / per_probe);
    tbb::parallel_for(std::size_t{0}, largest.size(), [&](std::size_t probe) {
        const float* was = &previous[probe * per_probe];
        const float* is = &next[probe * per_probe];
        largest[probe] = {
            largest_magnitude(per_probe, [&](std::size_t i) { return is[i]; }),
            largest_magnitude(per_probe, [&](std::size_t i) { return is[i] - was[i]; })};
    });
    float brightest = 0.f;
    for (const Largest& probe : largest) {
        if (!std::isfinite(probe.value) || !std::isfinite(probe.change)) {
            return {std::numeric_limits<double>::infinity(), false};
        }
        brightest = std::max(brightest, probe.value);
    }
    double relative = 0.;
    for (const Largest& probe : largest) {
        if (probe.change == 0.f) continue;
        const float scale = std::max(probe.value, brightest * darkest_of_brightest);
        relative = std::max(relative, double(probe.change) / double(scale));
    }
    return {relative, relative == 0.};
}

}  // namespace plumbline::ddgi
