// SPDX-License-Identifier: Apache-2.0
#include "scenes/geometry.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "scenes/camera_rays.h"

using namespace plumbline;

namespace {

/// Of any length between the given powers of two, a zero among its components now and then.
glm::vec3 random_vector(std::mt19937& engine, int least_exponent, int largest_exponent) {
    std::uniform_real_distribution<float> component(-1.f, 1.f);
    std::uniform_int_distribution<int> exponent(least_exponent, largest_exponent);
    std::uniform_int_distribution<int> kept(0, 4);
    glm::vec3 v(0.f);
    while (v == glm::vec3(0.f)) {
        for (int axis = 0; axis < 3; ++axis) v[axis] = kept(engine) > 0 ? component(engine) : 0.f;
    }
    const int e = exponent(engine);
    return {std::ldexp(v.x, e), std::ldexp(v.y, e), std::ldexp(v.z, e)};
}

constexpr int thousands = 20'000;

}  // namespace

TEST_CASE("a unit vector has the bits of glm::normalize where squares are floats", "[scenes]") {
    std::mt19937 engine(1);
    for (int i = 0; i < thousands; ++i) {
        // Squares of all components that are not tiny beside the others stay normal numbers.
        const glm::vec3 v = random_vector(engine, -40, 60);
        const glm::vec3 unit = unit_length(v), expected = glm::normalize(v);
        INFO(v.x << ' ' << v.y << ' ' << v.z);
        for (int axis = 0; axis < 3; ++axis) {
            if (unit[axis] != expected[axis]) FAIL(unit[axis] << " is not " << expected[axis]);
        }
    }
}

TEST_CASE("vectors of any length are brought to unit length", "[scenes]") {
    std::mt19937 engine(2);
    for (int i = 0; i < thousands; ++i) {
        const glm::vec3 v = random_vector(engine, -126, 127);
        const glm::dvec3 expected = glm::normalize(glm::dvec3(v));
        const glm::dvec3 unit(unit_length(v));
        INFO(v.x << ' ' << v.y << ' ' << v.z);
        // Three roundings of the square, one each of the root, its inverse and the product.
        constexpr double rounding = 3e-7;
        for (int axis = 0; axis < 3; ++axis) {
            if (!(std::abs(unit[axis] - expected[axis]) <= rounding))
                FAIL(unit[axis] << " is not " << expected[axis]);
        }
    }
}

TEST_CASE("a vector that is no number has no unit vector", "[scenes]") {
    const float none = std::numeric_limits<float>::quiet_NaN();
    CHECK(std::isnan(unit_length({none, 1.f, 1.f}).x));
    CHECK(std::isnan(unit_length({1.f, 1.f, none}).x));
    CHECK(std::isnan(unit_length(glm::vec3(0.f)).x));
}

TEST_CASE("a camera's rays do not depend on how long its view and its up are", "[scenes]") {
    const int view = GENERATE(-120, -60, 0, 30), up = GENERATE(-120, -60, 60, 120);
    Camera plain;
    plain.eye = glm::vec3(0.f);
    plain.target = {.3f, -.2f, .9f};
    plain.up = {.1f, 1.f, .05f};
    Camera camera = plain;
    camera.target = {std::ldexp(.3f, view), std::ldexp(-.2f, view), std::ldexp(.9f, view)};
    camera.up = {std::ldexp(.1f, up), std::ldexp(1.f, up), std::ldexp(.05f, up)};
    const glm::vec3 expected = CameraRays(plain).through(3.f, 5.f).direction;
    CHECK(CameraRays(camera).through(3.f, 5.f).direction == expected);
}
