// SPDX-License-Identifier: Apache-2.0
#include "ddgi/seen_probes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "ddgi/float8.h"
#include "ddgi/grid_cell.h"
#include "scenes/wide.h"

namespace plumbline::ddgi {
namespace {

/// What a probe straight behind the surface still counts: keeps the weights from all vanishing
/// [Majercik et al. 2019, section 5.2, listing 2: 0.2; less here, since nothing is denoised].
constexpr float least_backface_weight = .05f;

/// In cells: a probe this near to a surface behind it stands in that surface, and its rays start on
/// both sides of it.
constexpr float in_surface = 1e-3f;

/// Cosine between the surface's normal and the way to the probe; 1 where the point is the probe.
float cosine_to(const glm::vec3& way, const glm::vec3& n) {
    const float distance = glm::length(way);
    return distance > 0.f ? glm::dot(way, n) / distance : 1.f;
}

float backface_weight(float cosine) {
    const float wrapped = (cosine + 1.f) / 2.f;
    return wrapped * wrapped + least_backface_weight;
}

/// Ways that may be blocked, as many as are traced together.
struct Ways {
    SegmentLanes lanes;
    Lanes<std::uint32_t> question;  ///< of each: its point's number times 8 plus the probe's
};

using Corners = std::array<float, float8_lanes>;

/// Whether each of the eight probes around a point counts and stands in front of the surface (1 or
/// 0), and where its way then ends: a little behind the probe.
struct WaysOfPoint {
    std::array<std::uint32_t, float8_lanes> counts;
    Corners x, y, z;
};

/// The values of eight corners along an axis; bit `bit` of a corner's number says which end it is.
template <unsigned bit>
[[gnu::always_inline]] inline Float8 at_corners(float lower, float upper) {
    Float8 values;
    for (unsigned k = 0; k < float8_lanes; ++k) values[k] = (k >> bit & 1u) != 0 ? upper : lower;
    return values;
}

[[gnu::always_inline]] inline void put(const Float8& lanes, Corners& to) {
    std::memcpy(&to, &lanes, sizeof lanes);
}

[[gnu::always_inline]] inline WaysOfPoint ways_of(const ProbeGrid& grid, const glm::vec3& x,
                                                  const glm::vec3& n) {
    const glm::vec3 place = place_in(grid, x);
    const glm::ivec3 lower = cell_around(grid, place);
    const glm::vec3 upper_weight = upper_weights(place, lower);
    const glm::vec3 lower_weight = 1.f - upper_weight;
    const auto [a, b] = cell_bounds(grid, lower);
    const Float8 px = at_corners<2>(a.x, b.x);
    const Float8 py = at_corners<1>(a.y, b.y);
    const Float8 pz = at_corners<0>(a.z, b.z);
    const Float8 weight = at_corners<2>(lower_weight.x, upper_weight.x) *
                          at_corners<1>(lower_weight.y, upper_weight.y) *
                          at_corners<0>(lower_weight.z, upper_weight.z);
    const Float8 wx = px - x.x;
    const Float8 wy = py - x.y;
    const Float8 wz = pz - x.z;
    // Of a probe at the point itself NaN, which does not count.
    const Float8 inverse = 1.f / square_root(wx * wx + wy * wy + wz * wz);
    const float beyond = in_surface * grid.spacing;
    const auto counts = (weight != 0.f) & (wx * n.x + wy * n.y + wz * n.z > 0.f) & 1;
    WaysOfPoint ways;
    std::memcpy(&ways.counts, &counts, sizeof counts);
    put(px + beyond * (wx * inverse), ways.x);
    put(py + beyond * (wy * inverse), ways.y);
    put(pz + beyond * (wz * inverse), ways.z);
    return ways;
}

/// Fills `ways` with those from the points x[first] on; the first whose ways it has no room for.
PLUMBLINE_WIDE std::size_t fill(const ProbeGrid& grid, std::span<const glm::vec3> x,
                                std::span<const glm::vec3> n, std::size_t first, Ways& ways) {
    std::size_t count = 0;
    std::size_t i = first;
    for (; i < x.size() && count + float8_lanes <= plumbline::lane_count; ++i) {
        const WaysOfPoint of_point = ways_of(grid, x[i], n[i]);
        for (std::size_t k = 0; k < float8_lanes; ++k) {
            // Overwritten by the next if it does not count.
            ways.lanes.a.set(count, x[i]);
            ways.lanes.b.set(count, {of_point.x[k], of_point.y[k], of_point.z[k]});
            ways.question[count] = static_cast<std::uint32_t>(i * float8_lanes + k);
            count += of_point.counts[k];
        }
    }
    ways.lanes.count = count;
    return i;
}

}  // namespace

std::uint8_t seen_probes(const RayTracer& tracer, const ProbeGrid& grid, const glm::vec3& x,
                         const glm::vec3& n) {
    std::uint8_t seen;
    seen_probes(tracer, grid, {&x, 1}, {&n, 1}, {&seen, 1});
    return seen;
}

void seen_probes(const RayTracer& tracer, const ProbeGrid& grid, std::span<const glm::vec3> x,
                 std::span<const glm::vec3> n, std::span<std::uint8_t> seen) {
    std::ranges::fill(seen, std::uint8_t{0});
    Ways ways;
    Lanes<std::int32_t> hidden;
    for (std::size_t next = 0; next < x.size();) {
        next = fill(grid, x, n, next, ways);
        tracer.occluded(ways.lanes, hidden);
        for (std::size_t i = 0; i < ways.lanes.count; ++i) {
            const std::uint32_t question = ways.question[i];
            const unsigned bit = hidden[i] == 0 ? 1u << question % float8_lanes : 0u;
            std::uint8_t& of_point = seen[question / float8_lanes];
            of_point = static_cast<std::uint8_t>(of_point | bit);
        }
    }
}

Bounds bounds_to_probes(const ProbeGrid& grid, const glm::vec3& x) {
    Bounds bounds = cell_bounds(grid, cell_around(grid, place_in(grid, x)));
    bounds.extend(x);
    return bounds.grown(in_surface * grid.spacing);
}

float probe_weight(ProbeWeights weights, const glm::vec3& way, const glm::vec3& n, bool seen) {
    switch (weights) {
        case ProbeWeights::Backface:
            return backface_weight(cosine_to(way, n));
        case ProbeWeights::Visibility:
            return seen ? 1.f : 0.f;
        case ProbeWeights::Moments:
            return cosine_to(way, n) > 0.f ? 1.f : 0.f;
        case ProbeWeights::None:
            break;
    }
    return 1.f;
}

}  // namespace plumbline::ddgi
