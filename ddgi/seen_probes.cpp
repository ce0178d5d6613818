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

/// A value for each of the eight probes around a point.
struct WayEnds {
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

[[gnu::always_inline]] inline Float8 trilinear_weights(const glm::vec3& place,
                                                       const glm::ivec3& lower) {
    const glm::vec3 b = upper_weights(place, lower);
    const glm::vec3 a = 1.f - b;
    return at_corners<2>(a.x, b.x) * at_corners<1>(a.y, b.y) * at_corners<0>(a.z, b.z);
}

/// The ways from a point to the eight probes around it.
struct WaysOfPoint {
    Float8 px, py, pz;      ///< the probes
    Float8 wx, wy, wz;      ///< from the point to them
    glm::ivec3 lower;       ///< of the cell that it is in
    std::uint8_t in_front;  ///< bit k: probe k counts, and stands in front of the surface
};

[[gnu::always_inline]] inline WaysOfPoint ways_of(const ProbeGrid& grid, const glm::vec3& x,
                                                  const glm::vec3& n) {
    const glm::vec3 place = place_in(grid, x);
    WaysOfPoint ways;
    ways.lower = cell_around(grid, place);
    const auto [a, b] = cell_bounds(grid, ways.lower);
    ways.px = at_corners<2>(a.x, b.x);
    ways.py = at_corners<1>(a.y, b.y);
    ways.pz = at_corners<0>(a.z, b.z);
    ways.wx = ways.px - x.x;
    ways.wy = ways.py - x.y;
    ways.wz = ways.pz - x.z;
    const Float8 weight = trilinear_weights(place, ways.lower);
    const Float8 height = ways.wx * n.x + ways.wy * n.y + ways.wz * n.z;
    ways.in_front = bits_of((weight != 0.f) & (height > 0.f));
    return ways;
}

/// Where they end: a little behind the probes.
[[gnu::always_inline]] inline WayEnds ends_of(const WaysOfPoint& ways, float beyond) {
    // Of a probe at the point itself NaN; it is not in front.
    const Float8 inverse =
        1.f / square_root(ways.wx * ways.wx + ways.wy * ways.wy + ways.wz * ways.wz);
    WayEnds ends;
    put(ways.px + beyond * (ways.wx * inverse), ends.x);
    put(ways.py + beyond * (ways.wy * inverse), ends.y);
    put(ways.pz + beyond * (ways.wz * inverse), ends.z);
    return ends;
}

/// Points, and what is known of the probes that they see.
struct Questions {
    std::span<const glm::vec3> x, n;
    std::span<std::uint8_t> seen;
};

/// Answers for the points from `first` on what `planes` tell, and fills `ways` with the others'
/// rest; returns the first point whose ways it has no room for.
PLUMBLINE_WIDE std::size_t fill(const ProbeGrid& grid, const CellPlanes* planes,
                                const Questions& points, std::size_t first, Ways& ways) {
    std::size_t count = 0;
    std::size_t i = first;
    for (; i < points.x.size() && count + float8_lanes <= plumbline::lane_count; ++i) {
        const glm::vec3& x = points.x[i];
        const WaysOfPoint of_point = ways_of(grid, x, points.n[i]);
        const unsigned open = planes != nullptr ? planes->open_ways(of_point.lower, x) : 0u;
        points.seen[i] = static_cast<std::uint8_t>(of_point.in_front & open);
        const unsigned unknown = of_point.in_front & ~open;
        if (unknown == 0) continue;
        const WayEnds ends = ends_of(of_point, in_surface * grid.spacing);
        for (std::size_t k = 0; k < float8_lanes; ++k) {
            // Overwritten by the next if nothing is to be known of it.
            ways.lanes.a.set(count, x);
            ways.lanes.b.set(count, {ends.x[k], ends.y[k], ends.z[k]});
            ways.question[count] = static_cast<std::uint32_t>(i * float8_lanes + k);
            count += unknown >> k & 1u;
        }
    }
    ways.lanes.count = count;
    return i;
}

void answer(const RayTracer& tracer, const ProbeGrid& grid, const CellPlanes* planes,
            const Questions& points) {
    Ways ways;
    Lanes<std::int32_t> hidden;
    for (std::size_t next = 0; next < points.x.size();) {
        next = fill(grid, planes, points, next, ways);
        tracer.occluded(ways.lanes, hidden);
        for (std::size_t i = 0; i < ways.lanes.count; ++i) {
            const std::uint32_t question = ways.question[i];
            const unsigned bit = hidden[i] == 0 ? 1u << question % float8_lanes : 0u;
            std::uint8_t& of_point = points.seen[question / float8_lanes];
            of_point = static_cast<std::uint8_t>(of_point | bit);
        }
    }
}

}  // namespace

std::uint8_t seen_probes(const RayTracer& tracer, const ProbeGrid& grid, const glm::vec3& x,
                         const glm::vec3& n) {
    std::uint8_t seen;
    answer(tracer, grid, nullptr, {{&x, 1}, {&n, 1}, {&seen, 1}});
    return seen;
}

void seen_probes(const RayTracer& tracer, const ProbeGrid& grid, const CellPlanes& planes,
                 std::span<const glm::vec3> x, std::span<const glm::vec3> n,
                 std::span<std::uint8_t> seen) {
    answer(tracer, grid, &planes, {x, n, seen});
}

PLUMBLINE_WIDE ProbeNeighbours seen_neighbours(const ProbeGrid& grid, const glm::vec3& x,
                                               std::uint8_t seen) {
    const glm::vec3 place = place_in(grid, x);
    const glm::ivec3 lower = cell_around(grid, place);
    ProbeNeighbours around;
    const glm::ivec3 step = glm::min(grid.counts - 1 - lower, 1);
    const std::uint32_t first = probe_index(grid, lower);
    const auto along = [&](unsigned corner, unsigned bit, int further) {
        return (corner >> bit & 1u) * static_cast<std::uint32_t>(further);
    };
    for (unsigned k = 0; k < float8_lanes; ++k) {
        around.probe[k] = first + along(k, 1, step.y * grid.counts.x * grid.counts.z) +
                          along(k, 2, step.x * grid.counts.z) + along(k, 0, step.z);
    }
    const Float8 trilinear = trilinear_weights(place, lower);
    Float8 weights;
    for (unsigned k = 0; k < float8_lanes; ++k) {
        weights[k] = (seen >> k & 1u) != 0 ? trilinear[k] : 0.f;
    }
    const float sum = sum_of(weights);
    // Of denormal weights no digits would be left.
    weights = sum < std::numeric_limits<float>::min() ? trilinear : weights / sum;
    std::memcpy(&around.weight, &weights, sizeof weights);
    return around;
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
