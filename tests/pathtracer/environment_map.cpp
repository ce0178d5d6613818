// SPDX-License-Identifier: Apache-2.0
// Light from a picture all around: sampling, closed forms, and techniques that must agree.
#include "pathtracer/environment_map.h"

#include <catch2/catch.hpp>
#include <functional>
#include <memory>
#include <numbers>
#include <random>

#include "tests/pathtracer/scenes.h"
#include "tests/pathtracer/statistics.h"

namespace plumbline::pathtracer {
namespace {

using std::numbers::pi;

/// A floor that sees half of the environment, of albedo 1/2.
Scene open_floor(int width, int height, const std::function<Spectrum(int, int)>& radiance) {
    Scene scene;
    scene.name = "open floor";
    const int grey = test::add_material(scene, Spectrum(.5f));
    test::add_object(scene, Quad{{-9.f, 0.f, -9.f}, {0.f, 0.f, 18.f}, {18.f, 0.f, 0.f}, grey});
    auto panorama = std::make_shared<Panorama>();
    panorama->width = width;
    panorama->height = height;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) panorama->radiance.push_back(radiance(x, y));
    }
    scene.environment = Spectrum(1.f);
    scene.environment_image = EnvironmentImage{panorama, .3f};
    return scene;
}

/// Dark but for a few pixels, of which one is far brighter.
Spectrum uneven(int x, int y) {
    if (x == 5 && y == 1) return {300.f, 200.f, 100.f};
    return Spectrum(float((x * 7 + y * 3) % 5));
}

PixelEstimate floor_radiance(const World& world, const EnvironmentMap& map, Techniques techniques,
                             int batches, std::uint64_t seed) {
    const RayTracer tracer(world);
    PathOptions options = test::bounces(0);
    options.environment = &map;
    options.techniques = techniques;
    const Ray ray{{-3.f, 1.f, 0.f}, glm::normalize(glm::vec3(3.f, -1.f, 0.f))};
    return test::estimate_along(tracer, ray, batches, options, seed);
}

}  // namespace

TEST_CASE("a panorama's pixels lie where directions to them point", "[scenes]") {
    Panorama panorama;
    panorama.width = 24;
    panorama.height = 12;
    for (int y = 0; y < panorama.height; ++y) {
        for (int x = 0; x < panorama.width; ++x) {
            const glm::dvec2 middle((x + .5) / panorama.width, (y + .5) / panorama.height);
            CHECK(panorama.pixel(Panorama::direction(middle)) == std::size_t(y * 24 + x));
        }
    }
    // The middle is -z, to its right +x, the top row up.
    CHECK(glm::distance(Panorama::direction({.5, .5}), {0.f, 0.f, -1.f}) < 1e-6f);
    CHECK(glm::distance(Panorama::direction({.75, .5}), {1.f, 0.f, 0.f}) < 1e-6f);
    CHECK(glm::distance(Panorama::direction({.5, 0.}), {0.f, 1.f, 0.f}) < 1e-6f);
}

TEST_CASE("directions to a picture are chosen as their density says", "[pathtracer][statistics]") {
    const World world = world_at(open_floor(12, 6, uneven), 0);
    const EnvironmentMap map(world);
    const Panorama& panorama = *world.environment_image->panorama;
    constexpr int count = 400'000;
    std::mt19937 random(11);
    std::uniform_real_distribution<float> number(0.f, 1.f);
    std::vector<double> observed(panorama.radiance.size()), expected(panorama.radiance.size());
    for (int i = 0; i < count; ++i) {
        const auto sample = map.sample(
            {std::min(number(random), 0x1.fffffep-1f), std::min(number(random), 0x1.fffffep-1f)});
        const glm::vec3 in_picture =
            EnvironmentImage::turned(sample.wi, -world.environment_image->rotation);
        ++observed[panorama.pixel(in_picture)];
        REQUIRE(glm::length(sample.wi) == Approx(1.f).epsilon(1e-6));
    }
    // The density, summed over each pixel's solid angle.
    double sum = 0.;
    for (int y = 0; y < 6; ++y) {
        const double solid_angle =
            2. * pi / 12. * (std::cos(pi * y / 6.) - std::cos(pi * (y + 1) / 6.));
        for (int x = 0; x < 12; ++x) {
            const glm::vec3 wi =
                EnvironmentImage::turned(Panorama::direction({(x + .5) / 12., (y + .5) / 6.}),
                                         world.environment_image->rotation);
            const double share = double(map.pdf(wi)) * solid_angle;
            sum += share;
            expected[std::size_t(y * 12 + x)] = share * count;
        }
    }
    CHECK(sum == Approx(1.).epsilon(1e-5));
    std::vector<double> seen, due;
    for (std::size_t i = 0; i < observed.size(); ++i) {
        if (expected[i] == 0.) {
            CHECK(observed[i] == 0.);
            continue;
        }
        seen.push_back(observed[i]);
        due.push_back(expected[i]);
    }
    CHECK(::plumbline::test::chi_square_z(seen, due) < ::plumbline::test::sidak_limit(1));
}

TEST_CASE("a sky that is bright within 45 degrees of the top lights a floor by its sine squared",
          "[pathtracer][analytic]") {
    // E = integral of L cos over the cap of half angle t = pi L sin^2 t; radiance = rho E / pi.
    const auto techniques =
        GENERATE(Techniques::Both, Techniques::AimingOnly, Techniques::MeetingOnly);
    const World world =
        world_at(open_floor(8, 8, [](int, int y) { return Spectrum(y < 2 ? 4.f : 0.f); }), 0);
    const EnvironmentMap map(world);
    const PixelEstimate estimate = floor_radiance(world, map, techniques, 500, 1);
    const double expected = .5 * 4. * .5;
    const double mean = estimate.sums.radiance().y / estimate.sums.samples;
    const double deviation = std::sqrt(estimate.radiance_variance().y);
    // Of 16 stratified directions exactly 8 meet the cap, whose light then varies no more.
    CHECK(std::abs(mean - expected) < 4. * deviation + 1e-6 * expected);
    CHECK(deviation < .02 * expected);
}

TEST_CASE("aiming at a picture and meeting it agree and both shared out is quieter",
          "[pathtracer][statistics]") {
    const World world = world_at(open_floor(12, 6, uneven), 0);
    const EnvironmentMap map(world);
    const auto both = floor_radiance(world, map, Techniques::Both, 400, 1);
    const auto aiming = floor_radiance(world, map, Techniques::AimingOnly, 400, 2);
    const auto meeting = floor_radiance(world, map, Techniques::MeetingOnly, 400, 3);
    const auto z = [](const PixelEstimate& a, const PixelEstimate& b, int c) {
        const double difference =
            a.sums.radiance()[c] / a.sums.samples - b.sums.radiance()[c] / b.sums.samples;
        return difference / std::sqrt(a.radiance_variance()[c] + b.radiance_variance()[c]);
    };
    const double limit = ::plumbline::test::sidak_limit(6);
    for (int c = 0; c < 3; ++c) {
        CHECK(std::abs(z(both, aiming, c)) < limit);
        CHECK(std::abs(z(both, meeting, c)) < limit);
    }
    CHECK(both.radiance_variance().y < meeting.radiance_variance().y / 2.);
}

}  // namespace plumbline::pathtracer
