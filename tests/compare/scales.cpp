// SPDX-License-Identifier: Apache-2.0
#include "compare/scales.h"

#include <catch2/catch.hpp>
#include <random>

#include "tests/compare/test_images.h"

using namespace plumbline;
using namespace plumbline::compare;

TEST_CASE("independent noise halves with each doubling of the block", "[compare]") {
    std::mt19937 random(1);
    std::normal_distribution<float> normal;
    const Image zero = image_of(512, 512, [](int, int, int) { return 0.f; });
    const Image noise = image_of(512, 512, [&](int, int, int) { return normal(random); });
    const auto errors = error_by_scale(pair_layers(zero, noise, ""));
    REQUIRE(errors.size() == 7);
    CHECK(errors.back().width == 64);
    for (const ScaleError& error : errors)
        CHECK(error.rmse == Approx(error.if_noise).epsilon(0.15));
    CHECK(scale_slope(errors).value() == Approx(-1).margin(0.05));
    CHECK(scale_verdict(errors).starts_with("noise"));
}

TEST_CASE("independent noise is known as noise where a mask leaves few of a block's pixels",
          "[compare]") {
    std::mt19937 random(2);
    std::normal_distribution<float> normal;
    const Image zero = image_of(512, 512, [](int, int, int) { return 0.f; });
    const Image noise = image_of(512, 512, [&](int, int, int) { return normal(random); });
    const bool even = GENERATE(true, false);
    const Image mask = image_of(512, 512, [&](int x, int y, int) {
        return (even ? x % 4 : (x * 37 + y * y % 89 * 53) % 97 % 10) == 0 ? 1.f : 0.f;
    });
    const auto errors = error_by_scale(pair_layers(zero, noise, "", &mask));
    REQUIRE(errors.size() == 7);
    CHECK(scale_verdict(errors).starts_with("noise"));
    // 64 blocks, whose channels are three: 1 / sqrt(2 * 192) is .05.
    CHECK(errors.back().rmse == Approx(errors.back().if_noise).epsilon(0.15));
}

TEST_CASE("a constant bias is the same at every block width", "[compare]") {
    const Image zero = image_of(70, 40, [](int, int, int) { return 0.f; });
    const Image bias = image_of(70, 40, [](int, int, int) { return -0.25f; });
    const auto errors = error_by_scale(pair_layers(zero, bias, ""));
    REQUIRE(errors.size() == 6);  // a block of 64 does not fit
    for (const ScaleError& error : errors) CHECK(error.rmse == Approx(0.25));
    CHECK(scale_slope(errors).value() == Approx(0).margin(1e-9));
    CHECK(scale_verdict(errors) == "structure or bias: 16 times what noise leaves at width 16");
}

TEST_CASE("errors that cancel within two pixels vanish at width two", "[compare]") {
    const Image zero = image_of(8, 8, [](int, int, int) { return 0.f; });
    const Image stripes = image_of(8, 8, [](int x, int, int) { return x % 2 ? 1.f : -1.f; });
    const auto errors = error_by_scale(pair_layers(zero, stripes, ""));
    CHECK(errors[0].rmse == Approx(1));
    CHECK(errors[1].rmse == 0);
    CHECK(scale_verdict(errors).starts_with("errors that cancel"));
    CHECK_FALSE(scale_slope(errors));
}
