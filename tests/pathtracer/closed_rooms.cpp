// SPDX-License-Identifier: Apache-2.0
// Closed rooms, where the light of all bounces has a closed form.
#include <catch2/catch.hpp>
#include <numbers>
#include <random>

#include "pathtracer/render.h"
#include "tests/pathtracer/scenes.h"

namespace plumbline::pathtracer {
namespace {

using std::numbers::pi;
constexpr float pi_f = std::numbers::pi_v<float>;

/// 1 + rho + ... + rho^last
double series(double rho, int last) {
    double sum = 0.;
    for (int i = 0; i <= last; ++i) sum += std::pow(rho, i);
    return sum;
}

Scene inward_sphere(float radius, float rho, const glm::vec3& light, float intensity) {
    Scene scene;
    scene.name = "integrating sphere";
    const int wall = test::add_material(scene, Spectrum(rho));
    test::add_object(scene, Sphere{glm::vec3(0.f), radius, true, wall});
    scene.lights = {test::inverse_square(light, Spectrum(intensity))};
    return scene;
}

}  // namespace

TEST_CASE("furnace: radiance is the series Le (1 + rho + ... + rho^(B+1))",
          "[pathtracer][analytic]") {
    // In a closed box of uniform albedo and emission all paths carry equal radiance: zero variance,
    // so few samples must match to rounding.
    const float rho = GENERATE(0.f, .5f, .9f, 1.f);
    const int max_bounces = GENERATE(0, 1, 8, 16);
    constexpr float Le = .25f;
    Scene scene;
    scene.name = "furnace";
    const int wall = test::add_material(scene, Spectrum(rho), Spectrum(Le));
    for (const Quad& quad : test::room_walls({wall, wall, wall, wall, wall, wall})) {
        test::add_object(scene, quad);
    }
    scene.camera = {.eye = {.1f, .2f, .3f}, .target = {1.f, 0.f, 0.f}, .width = 8, .height = 6};
    const RenderResult result = render(scene, 0, {.spp = 32, .max_bounces = max_bounces});

    const double expected = Le * series(rho, max_bounces + 1);
    const double direct = Le * (1. + rho);
    const double bounce1 = max_bounces > 0 ? Le * rho * rho : 0.;
    for (const int c : {0, 1, 2}) {
        const auto channel = static_cast<std::size_t>(c);
        for (std::size_t i = 0; i < result.image.pixels(); ++i) {
            CHECK(result.image.layer("")[channel][i] == Approx(expected).epsilon(1e-5));
            CHECK(result.image.layer("direct")[channel][i] == Approx(direct).epsilon(1e-5));
            CHECK(result.image.layer("bounce1")[channel][i] == Approx(bounce1).epsilon(1e-5));
            CHECK(result.image.layer("variance")[channel][i] < 1e-12);
        }
    }
}

TEST_CASE("integrating sphere: the wall's irradiance is P / (4 pi R^2 (1 - rho))",
          "[pathtracer][analytic]") {
    // Between points of a sphere the form factor is the same for all, so that the light scattered
    // once or more arrives evenly wherever the lamp is [Jacquez and Kuppenheim 1955].
    const float rho = GENERATE(.3f, .8f, .95f);
    const float radius = GENERATE(.5f, 40.f);
    constexpr float intensity = 3.f;
    const glm::vec3 light = radius * glm::vec3(.2f, .3f, -.1f);
    const Scene scene = inward_sphere(radius, rho, light, intensity);
    const World world = world_at(scene, 0);
    const RayTracer tracer(world);
    const Ray ray{glm::vec3(0.f), glm::normalize(glm::vec3(1.f, -.4f, .7f))};
    const PixelEstimate estimate = test::estimate_along(tracer, ray, 2000, {});

    const double power = 4. * pi * intensity;
    const double wall = 4. * pi * double(radius) * double(radius);
    const double scattered = rho / pi * power / wall * rho / (1. - rho);
    const glm::dvec3 seen = glm::dvec3(ray.direction) * double(radius);
    const glm::dvec3 to_light = glm::dvec3(light) - seen;
    const double d2 = glm::dot(to_light, to_light);
    const double cosine = glm::dot(to_light, -glm::dvec3(ray.direction)) / std::sqrt(d2);
    const double direct = rho / pi * intensity * cosine / d2;

    CHECK(estimate.sums.direct.x / estimate.sums.samples == Approx(direct).epsilon(1e-5));
    CHECK(std::abs(test::radiance_z(estimate, 0, direct + scattered)) < 4.);
    const double standard_error = std::sqrt(estimate.radiance_variance().x);
    CHECK(standard_error < .02 * scattered);
    CHECK(standard_error > 0.);
}

TEST_CASE("a light of intensity pi at the centre of a unit sphere shows radiance 1",
          "[pathtracer][analytic]") {
    // A white wall shows albedo / pi * pi = 1 by direct light; a wall of albedo 1/2 shows 1/2, and
    // with all bounces (1/2) / (1 - 1/2) = 1 [pbrt's analytic test scenes].
    const auto seen = [](float rho, const PathOptions& options) {
        const Scene scene = inward_sphere(1.f, rho, glm::vec3(0.f), pi_f);
        const World world = world_at(scene, 0);
        const RayTracer tracer(world);
        return test::estimate_along(tracer, {glm::vec3(0.f), {0.f, .6f, .8f}}, 1000, options);
    };
    const PixelEstimate white = seen(1.f, test::bounces(0));
    CHECK(white.sums.radiance().x / white.sums.samples == Approx(1.).epsilon(1e-5));
    CHECK(std::abs(test::radiance_z(seen(.5f, {}), 1, 1.)) < 4.);
    const PixelEstimate cut = seen(.5f, test::bounces(20));
    CHECK(cut.sums.radiance().x / cut.sums.samples == Approx(1.).epsilon(1e-5));
}

TEST_CASE("a closed scene absorbs what its light emits", "[pathtracer][analytic]") {
    // A point of albedo rho and radiance L takes E = pi L / rho and absorbs (1 - rho) E. Summed
    // over uneven walls and a block inside, that is the lamp's 4 pi I.
    Scene scene;
    scene.name = "closed room";
    std::array<int, 6> walls{};
    for (std::size_t i = 0; i < walls.size(); ++i) {
        walls[i] = test::add_material(scene, Spectrum(.3f + .1f * static_cast<float>(i)));
    }
    const auto room = test::room_walls(walls);
    std::vector<Quad> surfaces(room.begin(), room.end());
    for (const Quad& wall : room) {
        // A block inside: the room turned inside out, smaller.
        surfaces.push_back({.25f * wall.corner + glm::vec3(.3f, -.2f, .1f), .25f * wall.edge_v,
                            .25f * wall.edge_u, wall.material});
    }
    for (const Quad& quad : surfaces) test::add_object(scene, quad);
    constexpr float intensity = 2.f;
    scene.lights = {test::inverse_square({-.4f, .5f, .3f}, Spectrum(intensity))};
    const World world = world_at(scene, 0);
    const RayTracer tracer(world);

    std::mt19937_64 random(11);
    std::uniform_real_distribution<float> uniform(0.f, 1.f);
    constexpr int points = 40'000;
    double absorbed = 0., variance = 0.;
    Wave<test::all_effects, RayTracer> wave(tracer, PathOptions{});
    for (const Quad& quad : surfaces) {
        const glm::vec3 area_normal = glm::cross(quad.edge_u, quad.edge_v);
        const glm::vec3 n = glm::normalize(area_normal);
        const double rho = scene.materials[std::size_t(quad.material)].albedo.x;
        double sum = 0., sum2 = 0.;
        for (int i = 0; i < points; ++i) {
            const glm::vec3 on_wall =
                quad.corner + uniform(random) * quad.edge_u + uniform(random) * quad.edge_v;
            wave.start({on_wall + .01f * n, -n}, Sampler(pixel_key(5, i, 0), 0));
        }
        for (const Path& path : wave.follow()) {
            const double value = double(glm::length(area_normal)) * (1. - rho) * pi / rho *
                                 (double(path.direct.x) + double(path.indirect.x));
            sum += value;
            sum2 += value * value;
        }
        absorbed += sum / points;
        variance += (sum2 / points - sum * sum / points / points) / points;
    }
    const double emitted = 4. * pi * intensity;
    CHECK(std::abs(absorbed - emitted) < 4. * std::sqrt(variance));
    CHECK(std::sqrt(variance) < .005 * emitted);
}

}  // namespace plumbline::pathtracer
