// SPDX-License-Identifier: Apache-2.0
#include "compare/color_maps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <span>

namespace plumbline::compare {

namespace {

/// Entries 0, 16, ... 240 and 255 of the published table of 256.
constexpr double viridis_step = 16.0 / 255.0;
constexpr std::array<glm::dvec3, 17> viridis{{
    {0.267004, 0.004874, 0.329415},
    {0.282327, 0.094955, 0.417331},
    {0.278826, 0.175490, 0.483397},
    {0.258965, 0.251537, 0.524736},
    {0.229739, 0.322361, 0.545706},
    {0.199430, 0.387607, 0.554642},
    {0.172719, 0.448791, 0.557885},
    {0.149039, 0.508051, 0.557250},
    {0.127568, 0.566949, 0.550556},
    {0.120638, 0.625828, 0.533488},
    {0.157851, 0.683765, 0.501686},
    {0.246070, 0.738910, 0.452024},
    {0.369214, 0.788888, 0.382914},
    {0.515992, 0.831158, 0.294279},
    {0.678489, 0.863742, 0.189503},
    {0.845561, 0.887322, 0.099702},
    {0.993248, 0.906157, 0.143936},
}};

/// The published colours of the scheme with 11 classes, blue first.
constexpr double blue_white_red_step = 1.0 / 10.0;
constexpr std::array<std::array<int, 3>, 11> blue_white_red{{
    {5, 48, 97},
    {33, 102, 172},
    {67, 147, 195},
    {146, 197, 222},
    {209, 229, 240},
    {247, 247, 247},
    {253, 219, 199},
    {244, 165, 130},
    {214, 96, 77},
    {178, 24, 43},
    {103, 0, 31},
}};

glm::dvec3 control_point(ColorMap map, std::size_t i) {
    if (map == ColorMap::Viridis) return viridis[std::min(i, viridis.size() - 1)];
    const auto& c = blue_white_red[std::min(i, blue_white_red.size() - 1)];
    return glm::dvec3(c[0], c[1], c[2]) / 255.0;
}

}  // namespace

Rgb8 map_color(ColorMap map, double t) {
    const double clamped = std::clamp(t, 0.0, 1.0);
    const double step = map == ColorMap::Viridis ? viridis_step : blue_white_red_step;
    const double place = std::floor(clamped / step);
    // The last interval of viridis is 15 entries wide, not 16.
    const double width = std::min(step, 1.0 - place * step);
    const double within = width > 0 ? (clamped - place * step) / width : 0.0;
    const std::size_t i = std::size_t(place);
    const glm::dvec3 color =
        glm::mix(control_point(map, i), control_point(map, i + 1), glm::dvec3(within));
    const auto byte = [](double value) { return std::uint8_t(std::lround(255.0 * value)); };
    return {byte(color.r), byte(color.g), byte(color.b)};
}

}  // namespace plumbline::compare
