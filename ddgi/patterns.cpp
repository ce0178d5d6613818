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

/// Cells of equal area in the upper octant around azimuth 0, as (cos polar angle, azimuth).
std::vector<glm::dvec2> even_octant(int count) {
    std::vector<glm::dvec2> cells;
    const int bands = std::max(1, static_cast<int>(std::lround(std::sqrt(double(count)))));
    int begin = 0;
    for (int band = 1; band <= bands; ++band) {
        // Bands even in polar angle, moved until each holds a whole number of cells.
        const double area = 1. - std::cos(pi / 2. * band / bands);
        const int end = static_cast<int>(std::lround(count * area));
        const double cos_polar = 1. - (begin + end) / (2. * count);
        for (int cell = 0; cell < end - begin; ++cell) {
            const double azimuth = pi / 2. * ((cell + 0.5) / (end - begin) - 0.5);
            cells.emplace_back(cos_polar, azimuth);
        }
        begin = end;
    }
    return cells;
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
