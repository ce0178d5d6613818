// SPDX-License-Identifier: Apache-2.0
#include "ddgi/direct_light.h"

#include <catch2/catch.hpp>
#include <glm/gtc/constants.hpp>

using namespace plumbline;
using namespace plumbline::ddgi;

namespace {

/// A half plane above the floor's points with x > 0, or nothing.
Scene open_floor(bool half_covered) {
    Scene scene;
    scene.materials.emplace_back();
    if (half_covered) {
        Object cover;
        cover.shape = Quad{{0.f, 1.f, -5.f}, {0.f, 0.f, 10.f}, {20.f, 0.f, 0.f}, 0};
        scene.objects = {cover};
    }
    return scene;
}

DirectLight light_at(const Scene& scene, const glm::vec3& position, int rays) {
    const World world = world_at(scene, 0);
    const RayTracer tracer(world);
    return direct_light(tracer, position, {0.f, 1.f, 0.f}, rays);
}

PointLight ball(float radius) {
    PointLight light;
    light.position = {0.f, 3.f, 0.f};
    light.intensity = Spectrum(4.f);
    light.radius = radius;
    return light;
}

}  // namespace

TEST_CASE("rays to a light with a radius bring what a sphere brings in closed form",
          "[ddgi][analytic]") {
    // E = pi L (r/d)^2 cos = I cos / d^2 for a sphere wholly above the horizon.
    const float radius = GENERATE(.01f, .8f, 2.5f);
    const float x = GENERATE(0.f, 1.f);
    Scene scene = open_floor(false);
    scene.lights = {ball(radius)};
    const double d2 = 9. + double(x) * double(x);
    const DirectLight light = light_at(scene, {x, 0.f, 0.f}, 1000);
    CHECK(light.irradiance.x == Approx(4. / d2 * 3. / std::sqrt(d2)).epsilon(2e-3));
    CHECK(light.shadow_rays == 1000);
}

TEST_CASE("one ray a point is right in the mean, and more rays come nearer at each point",
          "[ddgi][analytic]") {
    // Right below the light's centre, an edge through the centre leaves half of it.
    Scene scene = open_floor(true);
    scene.lights = {ball(.8f)};
    const World world = world_at(scene, 0);
    const RayTracer tracer(world);
    const double expected = 4. / 9. / 2.;
    constexpr int points = 2000;
    double squared[2] = {0., 0.};
    for (const int rays : {1, 64}) {
        double sum = 0.;
        for (int i = 0; i < points; ++i) {
            // Too near to each other for the closed form to tell them apart.
            const glm::vec3 position(0.f, 0.f, 1e-4f * static_cast<float>(i));
            const double E =
                double(direct_light(tracer, position, {0.f, 1.f, 0.f}, rays).irradiance.x);
            sum += E;
            squared[rays == 1 ? 0 : 1] += (E - expected) * (E - expected);
        }
        const double error = std::sqrt(squared[rays == 1 ? 0 : 1]) / points;
        CHECK(std::abs(sum / points - expected) < 4. * error + 1e-3 * expected);
    }
    CHECK(squared[1] < squared[0] / 64.);
}

TEST_CASE("spots and directional lights reach the floor as their closed forms tell",
          "[ddgi][analytic]") {
    Scene scene = open_floor(true);
    SECTION("a spot") {
        PointLight spot = ball(0.f);
        spot.cone = SpotCone{{0.f, -2.f, 0.f}, glm::radians(10.f), glm::radians(20.f)};
        scene.lights = {spot};
        CHECK(light_at(scene, {0.f, 0.f, 6.f}, 1).irradiance == Spectrum(0.f));
        CHECK(light_at(scene, {-.2f, 0.f, 0.f}, 1).irradiance.x ==
              Approx(4. * 3. / std::pow(9.04, 1.5)));
        CHECK(light_at(scene, {.2f, 0.f, 0.f}, 1).irradiance == Spectrum(0.f));
    }
    SECTION("a directional light") {
        scene.directional_lights = {{"sun", {3.f, -4.f, 0.f}, Spectrum(2.f)}};
        CHECK(light_at(scene, {-5.f, 0.f, 0.f}, 1).irradiance.y == Approx(1.6f));
        CHECK(light_at(scene, {5.f, 0.f, 0.f}, 1).irradiance.y == 0.f);
        CHECK(light_at(scene, {5.f, 2.f, 0.f}, 1).irradiance.y == Approx(1.6f));
    }
}
