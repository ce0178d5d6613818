// SPDX-License-Identifier: Apache-2.0
// Sphere, spot and directional lights on an open floor, against closed forms.
#include "pathtracer/lights.h"

#include <catch2/catch.hpp>
#include <numbers>
#include <random>

#include "pathtracer/kernels.h"
#include "tests/pathtracer/scenes.h"
#include "tests/pathtracer/statistics.h"

namespace plumbline::pathtracer {
namespace {

using std::numbers::pi;

constexpr float rho = .6f;

Scene floor_scene() {
    Scene scene;
    scene.name = "floor";
    const int material = test::add_material(scene, Spectrum(rho));
    test::add_object(scene,
                     Quad{{-50.f, 0.f, -50.f}, {0.f, 0.f, 100.f}, {100.f, 0.f, 0.f}, material});
    return scene;
}

/// Direct light seen at the floor's point (x, 0, 0).
PixelEstimate direct_at(const Scene& scene, float x, int batches) {
    const World world = world_at(scene, 0);
    const RayTracer tracer(world);
    const glm::vec3 eye(x, .2f, 8.f);
    const Ray ray{eye, glm::normalize(glm::vec3(x, 0.f, 0.f) - eye)};
    return test::estimate_along(tracer, ray, batches, test::bounces(0));
}

PointLight ball(const glm::vec3& position, float radius, float intensity) {
    PointLight light = test::inverse_square(position, Spectrum(intensity));
    light.radius = radius;
    return light;
}

double mean(const PixelEstimate& estimate) {
    return estimate.sums.direct.x / estimate.sums.samples;
}

}  // namespace

TEST_CASE("a sphere light above the horizon lights like the point at its centre",
          "[pathtracer][analytic]") {
    // E = pi L (r/d)^2 cos for a sphere wholly above the element's horizon; L = I / (pi r^2).
    const float x = GENERATE(0.f, 1.5f);
    const float radius = GENERATE(1e-3f, .5f, 1.4f);
    const bool falls_off = GENERATE(true, false);
    Scene scene = floor_scene();
    PointLight light = ball({0.f, 2.f, 0.f}, radius, 7.f);
    light.falloff = falls_off ? Falloff::InverseSquare : Falloff::None;
    light.white_radiance = Spectrum(.5f);
    scene.lights = {light};
    const PixelEstimate estimate = direct_at(scene, x, 400);
    const double d2 = 4. + double(x) * double(x);
    const double E = falls_off ? 7. / d2 : .5 * pi;
    const double expected = double(rho) / pi * E * 2. / std::sqrt(d2);
    // The rounding of a float where there is next to no noise.
    const double error = std::sqrt(estimate.radiance_variance().x) + 1e-6 * expected;
    CHECK(std::abs(mean(estimate) - expected) < 4. * error);
    CHECK(error < .01 * expected);
}

TEST_CASE("half of a sphere light is seen past an edge through its centre",
          "[pathtracer][analytic]") {
    // A half plane that ends right below the light, seen from the point right below: by symmetry
    // half of the sphere's light is left, in whichever direction the plane reaches.
    Scene scene = floor_scene();
    scene.lights = {ball({0.f, 3.f, 0.f}, .8f, 4.f)};
    const glm::vec3 reach = GENERATE(glm::vec3(20.f, 0.f, 0.f), glm::vec3(-20.f, 0.f, 0.f));
    test::add_object(scene, Quad{{0.f, 1.f, -5.f}, {0.f, 0.f, 10.f}, reach, 0});
    const PixelEstimate estimate = direct_at(scene, 0.f, 1000);
    const double expected = double(rho) / pi * 4. / 9. / 2.;
    CHECK(std::abs(test::radiance_z(estimate, 0, expected)) < 4.);
    CHECK(std::sqrt(estimate.radiance_variance().x) < .01 * expected);
}

TEST_CASE("a surface inside a sphere light gets nothing from it", "[pathtracer][analytic]") {
    Scene scene = floor_scene();
    scene.lights = {ball({0.f, .5f, 0.f}, 1.f, 4.f)};
    CHECK(direct_at(scene, 0.f, 1).sums.radiance() == glm::dvec3(0.));
}

TEST_CASE("directions to a sphere light fill its cone evenly", "[pathtracer][sampler]") {
    constexpr int rings = 10, sectors = 10, n = 100'000;
    std::mt19937_64 random(3);
    std::uniform_real_distribution<float> uniform(0.f, 1.f);
    const std::vector<float> radii{1e-4f, .1f, .999f};
    for (const float radius : radii) {
        const glm::vec3 to_center = 3.f * glm::normalize(glm::vec3(1.f, -2.f, .5f));
        const SphereCone cone = sphere_cone(to_center, 3.f * radius);
        const glm::vec3 u = glm::normalize(glm::cross(cone.axis, glm::vec3(0.f, 0.f, 1.f)));
        const glm::vec3 v = glm::cross(cone.axis, u);
        std::vector<double> observed(rings * sectors, 0.);
        for (int i = 0; i < n; ++i) {
            const glm::vec3 wi = sample_cone(cone, {uniform(random), uniform(random)});
            // sin^2 / (1 + cos) is 1 - cos without cancellation.
            const double sin2 = std::pow(double(glm::length(glm::cross(wi, cone.axis))), 2.);
            const double depth = sin2 / (1. + double(glm::dot(wi, cone.axis)));
            const double share = std::min(depth / double(cone.one_minus_cos), .999999);
            const double turn =
                std::atan2(double(glm::dot(wi, v)), double(glm::dot(wi, u))) / (2. * pi) + .5;
            const int sector = std::min(int(turn * sectors), sectors - 1);
            observed[std::size_t(int(share * rings) * sectors + sector)] += 1.;
        }
        const std::vector<double> expected(observed.size(), double(n) / (rings * sectors));
        CHECK(std::abs(::plumbline::test::chi_square_z(observed, expected)) <
              ::plumbline::test::sidak_limit(int(radii.size())));
        CHECK(cone.solid_angle() == Approx(2. * pi * (1. - std::sqrt(1. - radius * radius)))
                                        .epsilon(radius < .01f ? 1e-2 : 1e-5));
    }
}

TEST_CASE("a spot is whole inside its inner angle and dark outside its outer angle",
          "[pathtracer][analytic]") {
    Scene scene = floor_scene();
    PointLight light = test::inverse_square({0.f, 2.f, 0.f}, Spectrum(5.f));
    const float inner = glm::radians(20.f), outer = glm::radians(40.f);
    light.cone = SpotCone{{0.f, -3.f, 0.f}, inner, outer};
    scene.lights = {light};
    const auto seen_at = [&](double degrees) {
        const double x = 2. * std::tan(glm::radians(degrees));
        const double cosine = std::cos(glm::radians(degrees));
        const double whole = double(rho) / pi * 5. / (4. + x * x) * cosine;
        return mean(direct_at(scene, float(x), 1)) / whole;
    };
    CHECK(seen_at(0.) == Approx(1.).epsilon(1e-5));
    CHECK(seen_at(19.9) == Approx(1.).epsilon(1e-5));
    CHECK(seen_at(40.1) == 0.);
    const double ramp = (std::cos(glm::radians(30.)) - std::cos(double(outer))) /
                        (std::cos(double(inner)) - std::cos(double(outer)));
    CHECK(seen_at(30.) == Approx(ramp * ramp).epsilon(1e-4));
}

TEST_CASE("a directional light gives E cos at any distance, and nothing in a shadow",
          "[pathtracer][analytic]") {
    const float x = GENERATE(0.f, 30.f);
    Scene scene = floor_scene();
    scene.directional_lights = {{"sun", {3.f, -4.f, 0.f}, Spectrum(2.f)}};
    CHECK(mean(direct_at(scene, x, 1)) == Approx(double(rho) / pi * 2. * .8).epsilon(1e-5));
    // 4/3 of its height to the side.
    test::add_object(scene, Quad{{x - 75.1f, 100.f, -.1f}, {.2f, 0.f, 0.f}, {0.f, 0.f, .2f}, 0});
    CHECK(mean(direct_at(scene, x, 1)) == 0.);
    scene.directional_lights[0].direction = {0.f, 1.f, 0.f};
    CHECK(mean(direct_at(scene, x, 1)) == 0.);
}

TEST_CASE("there is a kernel for every set of effects, and the smallest comes first",
          "[pathtracer]") {
    for (std::size_t i = 0; i < kernels.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) CHECK_FALSE(covers(kernels[j], kernels[i]));
    }
    CHECK(covers(kernels.back(), test::all_effects));
}

}  // namespace plumbline::pathtracer
