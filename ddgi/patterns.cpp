// SPDX-License-Identifier: Apache-2.0
#include "ddgi/patterns.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numeric>

#include "ddgi/ray_blocks.h"
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

const double golden = (std::sqrt(5.) - 1.) / 2.;

/// Powers of the plastic constants of three and two dimensions [Roberts 2018]: by how much of a
/// full shift probes differ that are neighbours along x, y and z.
constexpr glm::dvec3 height_shifts(.819172513396164, .671043606703789, .549700477901970);
constexpr glm::dvec3 turn_shifts(.754877666246693, .569840290998053, .430159709001947);

/// Ray i of n on the sphere's lattice, slid and turned by parts in [0, 1) of a step and a turn.
glm::vec3 sphere_direction(int i, int n, double slide, double turn) {
    const double cos_polar = 1. - 2. * (i + slide) / n;
    return direction_at(cos_polar, 2. * pi * (std::fmod(golden * i, 1.) + turn));
}

/// The points of the sphere's lattice in an order in which each rays_in_block that follow each
/// other point much the same way: bands of heights, each sorted by azimuth.
std::vector<int> sphere_order(int n) {
    const int blocks = n / static_cast<int>(rays_in_block);
    // Of a band, which is 2 / bands high, as many blocks as make them as wide as high.
    const int bands = std::max(1, static_cast<int>(std::lround(std::sqrt(blocks / 2.))));
    std::vector<int> order(static_cast<std::size_t>(n));
    std::iota(order.begin(), order.end(), 0);
    for (int band = 0; band < bands; ++band) {
        const auto start = [&](int b) {
            return order.begin() + std::ptrdiff_t{blocks * b / bands} * rays_in_block;
        };
        std::ranges::sort(start(band), start(band + 1), {},
                          [](int i) { return std::fmod(golden * i, 1.); });
    }
    return order;
}

/// Throws UsageError.
void check_even(int surfels) {
    if (surfels >= 8 && surfels <= most_surfels && surfels % 8 == 0) return;
    throw UsageError("--surfels", fmt::format("{} rays do not share out over octants", surfels),
                     fmt::format("give a multiple of 8 from 8 to {}", most_surfels));
}

/// Points of an upper octant around azimuth 0, as (cos polar angle, azimuth): a rank-1 lattice with
/// the golden ratio, so that each stands for the same solid angle, centred in azimuth.
std::vector<glm::dvec2> even_octant(int count) {
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
    check_even(surfels);
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

RayPattern sphere_pattern(int surfels, bool shifted) {
    check_even(surfels);
    RayPattern pattern{{}, shifted, sphere_order(surfels)};
    for (const int i : pattern.lattice) {
        pattern.directions.push_back(sphere_direction(i, surfels, .5, 0.));
    }
    return pattern;
}

RayPattern turned(const RayPattern& pattern, int turn) {
    const glm::dvec3 u = glm::fract((turn + .5) * height_shifts);
    const double a = std::sqrt(1. - u.x);
    const double b = std::sqrt(u.x);
    const glm::dquat rotation(b * std::cos(2. * pi * u.z), a * std::sin(2. * pi * u.y),
                              a * std::cos(2. * pi * u.y), b * std::sin(2. * pi * u.z));
    RayPattern result = pattern;
    for (glm::vec3& direction : result.directions)
        direction = glm::vec3(glm::normalize(rotation * glm::dvec3(direction)));
    return result;
}

std::vector<glm::vec3> probe_directions(const RayPattern& pattern, const glm::ivec3& cell) {
    if (!pattern.shifted) return pattern.directions;
    const double slide = glm::fract(glm::dot(glm::dvec3(cell), height_shifts));
    const double turn = glm::fract(glm::dot(glm::dvec3(cell), turn_shifts));
    std::vector<glm::vec3> directions;
    for (const int i : pattern.lattice) {
        directions.push_back(sphere_direction(i, pattern.size(), slide, turn));
    }
    return directions;
}

}  // namespace plumbline::ddgi
