// SPDX-License-Identifier: Apache-2.0
// Direct light on an open floor, against closed forms.
#include <catch2/catch.hpp>
#include <numbers>

#include "tests/pathtracer/scenes.h"

namespace plumbline::pathtracer {
namespace {

using std::numbers::pi;

const Spectrum floor_albedo(.2f, .5f, .9f);

/// A floor at y = 0, looked at from above.
Scene floor_scene() {
    Scene scene;
    scene.name = "floor";
    const int material = test::add_material(scene, floor_albedo);
    test::add_object(scene,
                     Quad{{-50.f, 0.f, -50.f}, {0.f, 0.f, 100.f}, {100.f, 0.f, 0.f}, material});
    return scene;
}

/// Looks at the point (x, 0, z) from above, from a side.
Ray look_at(float x, float z) {
    const glm::vec3 eye(x + 1.f, 2.f, z - .5f);
    return {eye, glm::normalize(glm::vec3(x, 0.f, z) - eye)};
}

PixelEstimate direct_at(const Scene& scene, float x, float z, int batches) {
    const World world = world_at(scene, 0);
    const RayTracer tracer(world);
    return test::estimate_along(tracer, look_at(x, z), batches, test::bounces(0));
}

}  // namespace

TEST_CASE("a floor under a point light shows (albedo / pi) E cos", "[pathtracer][analytic]") {
    const float x = GENERATE(0.f, 1.5f, -20.f);
    const bool falls_off = GENERATE(false, true);
    Scene scene = floor_scene();
    PointLight light = test::inverse_square({0.f, 3.f, 0.f}, Spectrum(7.f));
    light.white_radiance = Spectrum(2.f);
    light.falloff = falls_off ? Falloff::InverseSquare : Falloff::None;
    scene.lights = {light};
    const PixelEstimate estimate = direct_at(scene, x, 0.f, 1);

    const double d2 = 9. + double(x) * double(x);
    const double E = falls_off ? 7. / d2 : 2. * pi;
    for (const int c : {0, 1, 2}) {
        const double expected = double(floor_albedo[c]) / pi * E * 3. / std::sqrt(d2);
        CHECK(estimate.sums.direct[c] / estimate.sums.samples == Approx(expected).epsilon(1e-5));
    }
    CHECK(estimate.sums.indirect == glm::dvec3(0.));
}

TEST_CASE("a point light below the floor or behind an object is not seen",
          "[pathtracer][analytic]") {
    Scene scene = floor_scene();
    SECTION("below") { scene.lights = {test::inverse_square({0.f, -1.f, 0.f}, Spectrum(1.f))}; }
    SECTION("in the floor") {
        scene.lights = {test::inverse_square({0.f, 0.f, 0.f}, Spectrum(1.f))};
    }
    SECTION("behind a quad, by whichever side") {
        const float side = GENERATE(-1.f, 1.f);
        scene.lights = {test::inverse_square({0.f, 3.f, 0.f}, Spectrum(1.f))};
        test::add_object(
            scene, Quad{{-.1f, 1.5f, -.1f * side}, {.2f, 0.f, 0.f}, {0.f, 0.f, .2f * side}, 0});
    }
    CHECK(direct_at(scene, 0.f, 0.f, 1).sums.radiance() == glm::dvec3(0.));
}

TEST_CASE("two lights add up", "[pathtracer][analytic]") {
    Scene scene = floor_scene();
    scene.lights = {test::inverse_square({0.f, 3.f, 0.f}, Spectrum(7.f))};
    const PixelEstimate one = direct_at(scene, 1.f, 0.f, 1);
    scene.lights.push_back(scene.lights.front());
    const PixelEstimate two = direct_at(scene, 1.f, 0.f, 1);
    CHECK(two.sums.direct.y == Approx(2. * one.sums.direct.y).epsilon(1e-6));
}

TEST_CASE("a glowing rectangle lights a parallel floor by its form factor",
          "[pathtracer][analytic]") {
    // From an element to a parallel rectangle a x b at distance c, a corner straight above the
    // element; A = a/c, B = b/c [Howell, A Catalog of Radiation Heat Transfer Configuration
    // Factors, B-3].
    constexpr double a = 2., b = 3., c = 1.5, Le = 4.;
    Scene scene = floor_scene();
    const int glowing = test::add_material(scene, Spectrum(0.f), Spectrum(float(Le)));
    test::add_object(scene,
                     Quad{{0.f, c, 0.f}, {float(a), 0.f, 0.f}, {0.f, 0.f, float(b)}, glowing});
    // Camera rays start above the rectangle's height, off its side.
    const PixelEstimate estimate = direct_at(scene, 0.f, 0.f, 2000);

    const double A = a / c, B = b / c;
    const double sA = std::sqrt(1. + A * A), sB = std::sqrt(1. + B * B);
    const double factor = (A / sA * std::atan(B / sA) + B / sB * std::atan(A / sB)) / (2. * pi);
    CHECK(std::abs(test::radiance_z(estimate, 1, double(floor_albedo.y) * Le * factor)) < 4.);
    CHECK(std::sqrt(estimate.radiance_variance().y) < .02 * double(floor_albedo.y) * Le * factor);
}

TEST_CASE("a glowing rectangle lights a perpendicular floor by its form factor",
          "[pathtracer][analytic]") {
    // From an element to a rectangle that stands upright, of width b and height a, at distance c,
    // its lower corner nearest; X = a/b, Y = c/b [Howell, A Catalog of Radiation Heat Transfer
    // Configuration Factors, B-4].
    constexpr double a = 3., b = 2., c = .8, Le = 4.;
    Scene scene = floor_scene();
    const int glowing = test::add_material(scene, Spectrum(0.f), Spectrum(float(Le)));
    test::add_object(
        scene, Quad{{-float(c), 0.f, 0.f}, {0.f, float(a), 0.f}, {0.f, 0.f, float(b)}, glowing});
    const PixelEstimate estimate = direct_at(scene, 0.f, 0.f, 2000);

    const double X = a / b, Y = c / b, root = std::sqrt(X * X + Y * Y);
    const double factor = (std::atan(1. / Y) - Y / root * std::atan(1. / root)) / (2. * pi);
    const double expected = double(floor_albedo.y) * Le * factor;
    CHECK(std::abs(test::radiance_z(estimate, 1, expected)) < 4.);
    CHECK(std::sqrt(estimate.radiance_variance().y) < .02 * expected);
}

TEST_CASE("a glowing sphere lights the floor below by (r / d)^2", "[pathtracer][analytic]") {
    // E = pi Le (r/d)^2 for an element that faces the centre of a sphere above its horizon.
    constexpr float Le = 3.f, r = 1.f, d = 2.5f;
    Scene scene = floor_scene();
    const int glowing = test::add_material(scene, Spectrum(0.f), Spectrum(Le));
    test::add_object(scene, Sphere{{0.f, d, 0.f}, r, false, glowing});
    const World world = world_at(scene, 0);
    const RayTracer tracer(world);
    const Ray ray{{-3.f, .5f, 0.f}, glm::normalize(glm::vec3(3.f, -.5f, 0.f))};
    const PixelEstimate estimate = test::estimate_along(tracer, ray, 2000, test::bounces(0));
    const double expected = double(floor_albedo.z * Le) * double(r * r / (d * d));
    CHECK(std::abs(test::radiance_z(estimate, 2, expected)) < 4.);
    CHECK(std::sqrt(estimate.radiance_variance().z) < .02 * expected);
}

TEST_CASE("an even sky of radiance 1 shows the floor's albedo", "[pathtracer][analytic]") {
    Scene scene = floor_scene();
    scene.environment = Spectrum(1.f);
    const PixelEstimate estimate = direct_at(scene, 3.f, -2.f, 1);
    CHECK(estimate.sums.radiance().x / estimate.sums.samples ==
          Approx(double(floor_albedo.x)).epsilon(1e-6));
}

TEST_CASE("the back of a surface is black unless it is two-sided", "[pathtracer][analytic]") {
    const bool two_sided = GENERATE(false, true);
    Scene scene = floor_scene();
    // A dome that faces outward and glows, under a bright sky: the floor inside sees its back
    // alone.
    const int dome = test::add_material(scene, Spectrum(.5f), Spectrum(2.f));
    scene.materials.back().two_sided = two_sided;
    test::add_object(scene, Sphere{glm::vec3(0.f), 30.f, false, dome});
    scene.environment = Spectrum(1.f);
    const PixelEstimate estimate = direct_at(scene, 0.f, 0.f, 10);
    const double expected = two_sided ? 2. * double(floor_albedo.x) : 0.;
    CHECK(estimate.sums.radiance().x / estimate.sums.samples == Approx(expected).epsilon(1e-6));
}

}  // namespace plumbline::pathtracer
