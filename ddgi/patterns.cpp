// SPDX-License-Identifier: Apache-2.0
#include "ddgi/patterns.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "scenes/errors.h"

namespace plumbline::ddgi {
namespace {

constexpr double pi = glm::pi<double>();
/// Above this a probe's rays no longer fit into the memory of any machine for the usual grids.
constexpr int most_surfels = 4096;

/// `azimuth` turns from +x to +z, as the published azimuths do.
glm::vec3 direction_at(double cos_polar, double azimuth) {
    const double sin_polar = std::sqrt(1. - cos_polar * cos_polar);
    return glm::vec3(sin_polar * std::cos(azimuth), cos_polar, sin_polar * std::sin(azimuth));
}

/// Points of an upper octant around azimuth 0, as (cos polar angle, azimuth): a rank-1 lattice with
/// the golden ratio, so that each stands for the same solid angle, centred in azimuth.
std::vector<glm::dvec2> even_octant(int count) {
    const double golden = (std::sqrt(5.) - 1.) / 2.;
    std::vector<glm::dvec2> points;
    double mean = 0.;
    for (int i = 0; i < count; ++i) {
        const double turn = std::fmod(golden * (i + .5), 1.);
        points.emplace_back((i + .5) / count, pi / 2. * turn);
        mean += points.back().y / count;
    }
    for (glm::dvec2& point : points) point.y -= mean;
    return points;
}

}  // namespace

RayPattern thesis_pattern(int surfels) {
    if (std::ranges::find(thesis_pattern_sizes, surfels) == thesis_pattern_sizes.end()) {
        throw UsageError("--surfels", fmt::format("the thesis has no pattern of {} rays", surfels),
                         fmt::format("give one of {}", fmt::join(thesis_pattern_sizes, ", ")));
    }
    const int azimuths = surfels / 8;
    const int azimuths_per_octant = azimuths / 4;
    RayPattern pattern;
    for (int d = 0; d < int{octant_count}; ++d) {
        const int first_ring = d < 4 ? 0 : 4;
        const int first_azimuth = d % 4 * azimuths_per_octant;
        for (int ring = first_ring; ring < first_ring + 4; ++ring) {
            const double polar = pi * ring / 8. + pi / 16.;
            for (int i = first_azimuth; i < first_azimuth + azimuths_per_octant; ++i) {
                const double step = 2. * pi / azimuths;
                const double azimuth = step * i - step * (surfels - 32) / 64.;
                pattern.directions.push_back(direction_at(std::cos(polar), azimuth));
            }
        }
    }
    return pattern;
}

RayPattern even_pattern(int surfels) {
    if (surfels < 8 || surfels > most_surfels || surfels % 8 != 0) {
        throw UsageError("--surfels", fmt::format("{} rays do not share out over octants", surfels),
                         fmt::format("give a multiple of 8 from 8 to {}", most_surfels));
    }
    const std::vector<glm::dvec2> octant = even_octant(surfels / 8);
    RayPattern pattern;
    for (int d = 0; d < int{octant_count}; ++d) {
        const double upper = d < 4 ? 1. : -1.;
        for (const glm::dvec2& cell : octant) {
            pattern.directions.push_back(direction_at(upper * cell.x, cell.y + pi / 2. * (d % 4)));
        }
    }
    return pattern;
}

}  // namespace plumbline::ddgi
