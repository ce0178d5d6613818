// SPDX-License-Identifier: Apache-2.0
#include "ddgi/change.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline::ddgi {
namespace {

constexpr float darkest_of_brightest = 1e-6f;

float largest_magnitude(std::span<const float> values) {
    float largest = 0.f;
    for (const float value : values) {
        // std::max would drop a NaN or keep it, depending on its place.
        if (!std::isfinite(value)) return std::numeric_limits<float>::infinity();
        largest = std::max(largest, std::abs(value));
    }
    return largest;
}

double relative_change(std::span<const float> previous, std::span<const float> next,
                       float darkest) {
    float change = 0.f;
    for (std::size_t i = 0; i < next.size(); ++i) {
        change = std::max(change, std::abs(next[i] - previous[i]));
    }
    const float scale = std::max(largest_magnitude(next), darkest);
    return change == 0.f ? 0. : double(change) / double(scale);
}

}  // namespace

Change change_between(std::span<const float> previous, std::span<const float> next,
                      std::size_t per_probe) {
    using Range = tbb::blocked_range<std::size_t>;
    const auto larger = [](auto a, auto b) { return std::max(a, b); };
    const Range probes(0, next.size() / per_probe);
    const auto largest_of = [&](auto identity, const auto& value_of) {
        return tbb::parallel_reduce(
            probes, identity,
            [&](const Range& range, auto largest) {
                for (std::size_t probe = range.begin(); probe < range.end(); ++probe) {
                    largest = std::max(largest, value_of(probe * per_probe));
                }
                return largest;
            },
            larger);
    };
    const float brightest = largest_of(
        0.f, [&](std::size_t first) { return largest_magnitude(next.subspan(first, per_probe)); });
    if (!std::isfinite(brightest)) return {std::numeric_limits<double>::infinity(), false};
    const double relative = largest_of(0., [&](std::size_t first) {
        return relative_change(previous.subspan(first, per_probe), next.subspan(first, per_probe),
                               brightest * darkest_of_brightest);
    });
    return {relative, relative == 0.};
}

}  // namespace plumbline::ddgi
