// SPDX-License-Identifier: Apache-2.0
#include "compare/error_maps.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "compare/flip_color.h"
#include "tests/compare/test_images.h"

using namespace plumbline;
using namespace plumbline::compare;

namespace {

/// CIE L* of a display colour.
double lightness(Rgb8 color) {
    const auto linear = [](std::uint8_t byte) { return linear_from_srgb(float(byte) / 255.f); };
    const double y =
        double(xyz_from_linear_rgb({linear(color.r), linear(color.g), linear(color.b)}).y);
    return 116 * std::cbrt(y) - 16;
}

Rgb8 color_at(const Picture& picture, int x, int y) {
    const std::size_t i = (std::size_t(y) * std::size_t(picture.width) + std::size_t(x)) * 3;
    return {picture.rgb[i], picture.rgb[i + 1], picture.rgb[i + 2]};
}

const ErrorMap& named(const std::vector<ErrorMap>& maps, const std::string& name) {
    for (const ErrorMap& map : maps)
        if (map.name == name) return map;
    throw std::out_of_range(name);
}

}  // namespace

TEST_CASE("viridis follows the published polynomial and rises evenly in lightness", "[compare]") {
    // Polynomial fit by M. Zucker (CC0), https://www.shadertoy.com/view/WlfXRN.
    const glm::dvec3 fit[] = {{0.2777273272, 0.0054073445, 0.3340998053},
                              {0.1050930431, 1.4046135299, 1.3845901626},
                              {-0.3308618287, 0.2148475595, 0.0950951630},
                              {-4.6342304990, -5.7991009734, -19.3324409563},
                              {6.2282699363, 14.1799333668, 56.6905526007},
                              {4.7763849977, -13.7451453777, -65.3530326334},
                              {-5.4354558559, 4.6458526122, 26.3124352496}};
    double previous = lightness(map_color(ColorMap::Viridis, 0));
    for (int k = 1; k <= 50; ++k) {
        const double t = k / 50.0;
        glm::dvec3 expected(0);
        for (int power = 6; power >= 0; --power) expected = expected * t + fit[power];
        const Rgb8 color = map_color(ColorMap::Viridis, t);
        CHECK(color.r / 255.0 == Approx(expected.r).margin(0.02));
        CHECK(color.g / 255.0 == Approx(expected.g).margin(0.02));
        CHECK(color.b / 255.0 == Approx(expected.b).margin(0.03));
        CHECK(lightness(color) - previous == Approx(1.5).margin(0.6));
        previous = lightness(color);
    }
}

TEST_CASE("the diverging map is lightest in the middle and darkens alike on both sides",
          "[compare]") {
    for (int k = 0; k < 20; ++k) {
        const double here = lightness(map_color(ColorMap::BlueWhiteRed, 0.5 + 0.025 * k));
        CHECK(lightness(map_color(ColorMap::BlueWhiteRed, 0.5 + 0.025 * (k + 1))) < here);
        CHECK(lightness(map_color(ColorMap::BlueWhiteRed, 0.5 - 0.025 * k)) ==
              Approx(here).margin(9));
    }
    CHECK(map_color(ColorMap::BlueWhiteRed, -3) == map_color(ColorMap::BlueWhiteRed, 0));
    CHECK(map_color(ColorMap::Viridis, 7) == Rgb8{253, 231, 37});
}

TEST_CASE("error maps hold the errors of each pixel", "[compare]") {
    const Image r = image_of(3, 1, [](int, int, int) { return 1.f; });
    Image t = image_of(3, 1, [](int x, int, int c) { return x == 1 && c == 0 ? 0.4f : 1.f; });
    t.channel("G")[2] = std::nanf("");
    const auto maps = error_maps(r, t, compare_images(r, t, ""));
    CHECK(named(maps, "signed").values[0] == 0.f);
    CHECK(named(maps, "signed").values[1] == Approx(-0.2f));
    CHECK(std::isnan(named(maps, "signed").values[2]));
    CHECK(named(maps, "absolute").values[1] == Approx(0.2f));
    CHECK(named(maps, "relative").values[1] == Approx(-0.6f / 1.41f / 3));
    CHECK_THROWS(named(maps, "z"));
}

TEST_CASE("the z map shows the channel that deviates most", "[compare]") {
    const Image r = image_of(2, 1, [](int, int, int) { return 1.f; });
    Image t =
        image_of(2, 1, [](int x, int, int c) { return x == 0 ? 1.f : 1.f - 0.1f * float(c); });
    for (auto& channel : t.layer("variance")) channel[0] = channel[1] = 0.01f;
    const auto maps = error_maps(r, t, compare_images(r, t, ""));
    CHECK(named(maps, "z").values[0] == 0.f);
    CHECK(named(maps, "z").values[1] == Approx(-2.f));
}

TEST_CASE("a limit is a round number that 99 percent of errors stay below", "[compare]") {
    const Image r = image_of(100, 1, [](int, int, int) { return 0.f; });
    const Image t = image_of(100, 1, [](int x, int, int) { return x == 99 ? 50.f : 0.03f; });
    CHECK(error_limit(pair_layers(r, t, "")) == Approx(0.05));
    CHECK(error_limit(pair_layers(r, r, "")) == 1.0);
}

TEST_CASE("a false-colour picture has the map above a scale bar with numbers", "[compare]") {
    ErrorMap map{"signed", "", 300, 40, std::vector<float>(300 * 40, 0.f), ColorMap::BlueWhiteRed,
                 -1,       1};
    map.values[0] = 1.f;
    map.values[1] = -5.f;
    map.values[2] = std::nanf("");
    const Picture picture = false_color(map);
    REQUIRE(picture.width == 300);
    REQUIRE(picture.height > 40 + 14);
    CHECK(color_at(picture, 0, 0) == map_color(map.colors, 1));
    CHECK(color_at(picture, 1, 0) == map_color(map.colors, 0));
    CHECK(color_at(picture, 2, 0) == no_value_color);
    // The bar runs from the first to the last colour.
    CHECK(color_at(picture, 12, 50) == map_color(map.colors, 0));
    CHECK(color_at(picture, 300 - 13, 50) == map_color(map.colors, 1));
    CHECK(color_at(picture, 150, 50) == map_color(map.colors, 138.0 / 275.0));
    // Below it, the numbers: some ink under either end.
    const auto ink_between = [&](int left, int right) {
        int dots = 0;
        for (int y = 40 + 6 + 14 + 4; y < picture.height; ++y)
            for (int x = left; x < right; ++x) dots += color_at(picture, x, y) == Rgb8{20, 20, 20};
        return dots;
    };
    CHECK(ink_between(0, 30) > 10);
    CHECK(ink_between(270, 300) > 5);
    CHECK(ink_between(30, 60) == 0);
}

TEST_CASE("a drawn number has the dots of its digits", "[compare]") {
    Picture picture(20, 9, {255, 255, 255});
    draw_number(picture, 1, 1, 1, "1.", {0, 0, 0});
    CHECK(text_width("1.", 1) == 11);
    CHECK(color_at(picture, 3, 1) == Rgb8{0, 0, 0});  // top of the 1
    CHECK(color_at(picture, 1, 1) == Rgb8{255, 255, 255});
    CHECK(color_at(picture, 8, 7) == Rgb8{0, 0, 0});  // the point
    CHECK(color_at(picture, 8, 3) == Rgb8{255, 255, 255});
}
