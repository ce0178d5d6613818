// SPDX-License-Identifier: Apache-2.0
#include "reports/pareto.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace plumbline::reports;

namespace {

std::vector<std::string> settings(const std::vector<TimedError>& points) {
    std::vector<std::string> names;
    for (const std::size_t i : pareto_set(points)) names.push_back(points[i].setting);
    return names;
}

/// Error 1 / sqrt(t), and two models: quick and rough, slow and exact.
const std::vector<TimedError> made_up{
    {"traced", "1", 1, 1},      {"traced", "4", 4, .5},      {"traced", "16", 16, .25},
    {"rough", "a", .25, .9},    {"rough", "b", .5, .42},     {"rough", "c", 2, .4},
    {"exact", "64", 3, .1},     {"exact", "slow", 50, .096}, {"exact", "slower", 60, .08},
    {"exact", "worst", 70, .2}, {"rough", "wasted", 3, .9}};

}  // namespace

TEST_CASE("the Pareto set is what no other point beats", "[reports][frontier]") {
    CHECK(settings(made_up) == std::vector<std::string>{"a", "b", "c", "64", "slow", "slower"});
    CHECK(settings({}).empty());
    CHECK(settings({{"m", "first", 1, 1}, {"m", "equal", 1, 1}, {"m", "slower", 2, 1}}) ==
          std::vector<std::string>{"first"});
    CHECK(settings({{"m", "worse", 1, 2}, {"m", "better", 1, 1}}) ==
          std::vector<std::string>{"better"});
}

TEST_CASE("of random points exactly those are Pareto that no other is below in both",
          "[reports][frontier]") {
    std::mt19937 random(5);
    std::uniform_int_distribution<int> value(1, 30);
    std::vector<TimedError> points;
    for (int i = 0; i < 200; ++i)
        points.push_back({"m", std::to_string(i), double(value(random)), double(value(random))});
    const std::vector<std::size_t> set = pareto_set(points);
    const auto covered = [&](const TimedError& by, const TimedError& point) {
        return by.seconds <= point.seconds && by.error <= point.error;
    };
    for (const TimedError& point : points) {
        int covers = 0;
        for (const std::size_t i : set) covers += covered(points[i], point);
        CHECK(covers > 0);
    }
    for (const std::size_t a : set)
        for (const std::size_t b : set) CHECK((a == b || !covered(points[a], points[b])));
}

TEST_CASE("a method's floor is its least error, with the quickest way to a tenth above",
          "[reports][frontier]") {
    const std::vector<ErrorFloor> floors = error_floors(made_up);
    REQUIRE(floors.size() == 3);
    CHECK(floors[0].floor.setting == "16");
    CHECK(floors[0].tenth_above.setting == "16");
    CHECK(floors[1].floor.setting == "c");
    CHECK(floors[1].tenth_above.setting == "b");  // .9 * .42 < .4
    CHECK(floors[2].floor.setting == "slower");
    CHECK(floors[2].tenth_above.setting == "slower");  // .9 * .096 > .08
}

TEST_CASE("the path tracer's law tells how long an error takes, and when it extrapolates",
          "[reports][frontier]") {
    const ErrorLaw law = fit_error_law(made_up, "traced").value();
    CHECK(law.law.exponent == Approx(-.5));
    CHECK(law.seconds_to(.1) == Approx(100));
    CHECK(law.error_after(25) == Approx(.2));
    CHECK(law.extrapolates(17));
    CHECK_FALSE(law.extrapolates(16));
    CHECK_FALSE(fit_error_law(made_up, "unknown").has_value());
    const std::vector<TimedError> rising{{"m", "", 1, 1}, {"m", "", 2, 2}};
    CHECK_FALSE(fit_error_law(rising, "m").has_value());
}

TEST_CASE("at each budget the method with the least error is named", "[reports][frontier]") {
    const std::vector<Reign> reigns = best_by_budget(made_up, fit_error_law(made_up, "traced"));
    // 1 / sqrt(t) undercuts the exact model's .1 at 100, but its .08, there from 60 on, at 156.25.
    REQUIRE(reigns.size() == 3);
    CHECK(reigns[0].method == "rough");
    CHECK(reigns[0].from_seconds == .25);
    CHECK(reigns[0].until_seconds == 3);
    CHECK(reigns[0].error_from == .9);
    CHECK(reigns[0].error_until == .4);
    CHECK(reigns[1].method == "exact");
    CHECK(reigns[1].until_seconds == Approx(156.25));
    CHECK(reigns[1].error_from == .1);
    CHECK(reigns[1].error_until == .08);
    CHECK(reigns[2].method == "traced");
    CHECK(std::isinf(reigns[2].until_seconds));
    CHECK(reigns[2].error_from == Approx(.08));
}

TEST_CASE("the path tracer may rule in between, and needs no model", "[reports][frontier]") {
    std::vector<TimedError> points{
        {"traced", "", 1, 1}, {"traced", "", 4, .5}, {"model", "", 16, .1}};
    const auto law = fit_error_law(points, "traced");
    const std::vector<Reign> reigns = best_by_budget(points, law);
    REQUIRE(reigns.size() == 3);
    CHECK(reigns[0].method == "traced");
    CHECK(reigns[0].error_until == Approx(.25));
    CHECK(reigns[1].method == "model");
    CHECK(reigns[1].until_seconds == Approx(100));
    points.pop_back();
    CHECK(best_by_budget(points, law).size() == 1);
    CHECK(best_by_budget(points, std::nullopt).size() == 1);
    CHECK(best_by_budget({}, std::nullopt).empty());
}
