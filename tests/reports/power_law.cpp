// SPDX-License-Identifier: Apache-2.0
#include "reports/power_law.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

using namespace plumbline::reports;

TEST_CASE("an exact power law is found without uncertainty", "[reports][cost]") {
    const std::vector<double> x{1, 8, 27, 64};
    std::vector<double> y;
    for (const double value : x) y.push_back(3 * std::pow(value, 1.5));
    const PowerLaw law = fit_power_law(x, y).value();
    CHECK(law.exponent == Approx(1.5));
    CHECK(law.scale == Approx(3));
    CHECK(law.exponent_ci95[1] - law.exponent_ci95[0] < 1e-6);
}

TEST_CASE("the interval of an exponent holds the true one in 95 of 100 cases", "[reports][cost]") {
    std::mt19937_64 random(7);
    std::normal_distribution<double> noise(0, .2);
    const std::vector<double> x{1, 2, 4, 8, 16, 32};
    constexpr int trials = 4000;
    int held = 0;
    for (int trial = 0; trial < trials; ++trial) {
        std::vector<double> y;
        for (const double value : x) y.push_back(std::pow(value, .8) * std::exp(noise(random)));
        const PowerLaw law = fit_power_law(x, y).value();
        if (law.exponent_ci95[0] <= .8 && .8 <= law.exponent_ci95[1]) ++held;
    }
    // Four standard errors of a share of .95 in 4000.
    CHECK(double(held) / trials == Approx(.95).margin(4 * std::sqrt(.95 * .05 / trials)));
}

TEST_CASE("what has no power law gets none", "[reports][cost]") {
    const std::vector<double> one{1}, twice{2, 2}, two{1, 2}, zero{0, 1};
    CHECK_FALSE(fit_power_law(one, one).has_value());
    CHECK_FALSE(fit_power_law(twice, two).has_value());
    CHECK_FALSE(fit_power_law(two, zero).has_value());
    CHECK(std::isinf(fit_power_law(two, two)->exponent_ci95[1]));
}
