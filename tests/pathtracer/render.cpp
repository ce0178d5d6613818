// SPDX-License-Identifier: Apache-2.0
#include "pathtracer/render.h"

#include <tbb/global_control.h>

#include <catch2/catch.hpp>
#include <limits>

#include "pathtracer/passes.h"
#include "tests/pathtracer/pictures.h"
#include "tests/pathtracer/scenes.h"
#include "tests/pathtracer/statistics.h"

namespace plumbline::pathtracer {
namespace {

RenderResult render_with_threads(std::size_t threads, const Scene& scene,
                                 const RenderOptions& options) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return render(scene, 0, options);
}

using test::same_bits;
using test::same_pixels;

/// Mean over pixels and channels of a layer, with its variance.
struct Mean {
    double value = 0.;
    double variance = 0.;
};

Mean mean_of(const Image& image, const std::string& layer, const std::string& variance_layer) {
    Mean mean;
    const double n = 3. * double(image.pixels());
    for (const std::string c : {"R", "G", "B"}) {
        const auto values = image.channel(channel_name(layer, c));
        const auto variances = image.channel(channel_name(variance_layer, c));
        for (const float v : values) mean.value += double(v) / n;
        for (const float v : variances) mean.variance += double(v) / (n * n);
    }
    // Channels of a pixel share their paths: at worst their errors add up.
    mean.variance *= 3.;
    return mean;
}

double z_between(const Mean& a, const Mean& b) {
    return (a.value - b.value) / std::sqrt(a.variance + b.variance);
}

}  // namespace

TEST_CASE("one thread and two give the same bits", "[pathtracer]") {
    const Scene scene = test::mixed_room(45, 37);
    const RenderOptions options{.spp = 40, .seed = 9};
    const RenderResult one = render_with_threads(1, scene, options);
    const RenderResult two = render_with_threads(2, scene, options);
    CHECK(same_pixels(one.image, two.image));
    CHECK(one.rays == two.rays);
    CHECK(one.relmse_estimate == two.relmse_estimate);
}

TEST_CASE("another seed gives another picture of the same scene", "[pathtracer]") {
    const Scene scene = test::mixed_room(16, 16);
    const Image a = render(scene, 0, {.spp = 64, .seed = 0}).image;
    const Image b = render(scene, 0, {.spp = 64, .seed = 1}).image;
    CHECK_FALSE(same_bits(a.channel("indirect.G"), b.channel("indirect.G")));
    CHECK(std::abs(z_between(mean_of(a, "", "variance"), mean_of(b, "", "variance"))) < 4.);
}

TEST_CASE("a picture stopped by its error has the pixels of one of as many samples",
          "[pathtracer]") {
    const Scene scene = test::mixed_room(20, 15);
    const RenderResult stopped = render(scene, 0, {.spp = 1 << 20, .target_relmse = .004});
    CHECK(stopped.relmse_estimate <= .004);
    CHECK(stopped.spp >= 32);
    CHECK(stopped.spp < 1 << 20);
    const RenderResult counted = render(scene, 0, {.spp = stopped.spp});
    CHECK(same_pixels(stopped.image, counted.image));
    // One batch less had not reached it.
    CHECK(render(scene, 0, {.spp = stopped.spp - Sampler::batch_size}).relmse_estimate > .004);
}

TEST_CASE("a picture stopped by the clock ends on whole batches", "[pathtracer]") {
    const Scene scene = test::mixed_room(20, 15);
    const RenderResult result = render(scene, 0, {.spp = 1 << 20, .seconds = .2});
    CHECK(result.spp % Sampler::batch_size == 0);
    CHECK(result.spp < 1 << 20);
    CHECK(result.image.channel("samples.Y")[7] == float(result.spp));
}

TEST_CASE("direct and bounce1 are what one indirect bounce shows", "[pathtracer]") {
    const Scene scene = test::mixed_room(32, 24);
    const Image all = render(scene, 0, {.spp = 64, .seed = 1}).image;
    const Image one = render(scene, 0, {.spp = 64, .max_bounces = 1, .seed = 2}).image;
    const Image none = render(scene, 0, {.spp = 64, .max_bounces = 0, .seed = 3}).image;
    // The variance of bounce1 is at most that of indirect, of which it is a part.
    const Mean bounce1 = mean_of(all, "bounce1", "variance_indirect");
    CHECK(std::abs(z_between(bounce1, mean_of(one, "indirect", "variance_indirect"))) < 4.);
    CHECK(std::abs(z_between(mean_of(all, "direct", "variance"), mean_of(none, "", "variance"))) <
          4.);
    CHECK(same_bits(one.channel("bounce1.G"), one.channel("indirect.G")));
    for (const float v : none.channel("indirect.G")) CHECK(v == 0.f);
    for (std::size_t i = 0; i < all.pixels(); ++i) {
        CHECK(all.channel("G")[i] ==
              Approx(all.channel("direct.G")[i] + all.channel("indirect.G")[i]));
    }
}

TEST_CASE("roulette changes the noise, not the mean", "[pathtracer]") {
    const World world = world_at(test::mixed_room(8, 8), 0);
    const RayTracer tracer(world);
    const Ray ray{{0.f, 0.f, .9f}, glm::normalize(glm::vec3(.2f, -.4f, -1.f))};
    const PathOptions full{.max_scatterings = 40, .roulette = false};
    const PathOptions early{.max_scatterings = 40, .roulette_start = 1};
    const PixelEstimate a = test::estimate_along(tracer, ray, 4000, full, 1);
    const PixelEstimate b = test::estimate_along(tracer, ray, 4000, early, 2);
    for (const int c : {0, 1, 2}) {
        const double difference =
            a.sums.radiance()[c] / a.sums.samples - b.sums.radiance()[c] / b.sums.samples;
        const double variance = a.radiance_variance()[c] + b.radiance_variance()[c];
        CHECK(std::abs(difference) < 4. * std::sqrt(variance));
        CHECK(std::sqrt(variance) < .01 * a.sums.radiance()[c] / a.sums.samples);
    }
}

TEST_CASE("roulette changes the mean of no pixel", "[pathtracer][statistics]") {
    // z-test of each pixel and channel with the variances of both pictures [Sidak 1967]. With 64
    // batches a picture, z has Student's distribution with 126 degrees of freedom, near normal.
    constexpr int width = 12, height = 9, spp = 64 * Sampler::batch_size;
    const World world = world_at(test::mixed_room(width, height), 0);
    const RayTracer tracer(world);
    const auto gathered = [&](const PathOptions& options, std::uint64_t seed) {
        Passes passes(tracer, test::all_effects, options, seed);
        Progress progress("test", passes.steps(spp));
        passes.add({spp, Sampler::batch_size}, progress);
        return passes.pixels();
    };
    const auto full = gathered({.max_scatterings = 30, .roulette = false}, 1);
    const auto early = gathered({.max_scatterings = 30, .roulette_start = 1}, 2);
    const double limit = plumbline::test::sidak_limit(3 * width * height);
    double squares = 0.;
    for (std::size_t i = 0; i < full.size(); ++i) {
        for (const int c : {0, 1, 2}) {
            const double difference =
                (full[i].sums.radiance()[c] - early[i].sums.radiance()[c]) / spp;
            const double z = difference / std::sqrt(full[i].radiance_variance()[c] +
                                                    early[i].radiance_variance()[c]);
            CHECK(std::abs(z) < limit);
            squares += z * z;
        }
    }
    // The variances are right too, not just large. Channels of a pixel may err alike, so that z^2
    // has the spread of one deviate a pixel.
    const double mean_square = squares / (3. * width * height);
    CHECK(std::abs(mean_square - 1.) < 4. * std::sqrt(2. / (width * height)));
}

TEST_CASE("code for effects that the scene lacks changes no bit", "[pathtracer]") {
    Scene scene = test::mixed_room(12, 12);
    SECTION("no emission") { scene.materials.back().emission = Spectrum(0.f); }
    SECTION("no point light") { scene.lights.clear(); }
    const World world = world_at(scene, 0);
    const RayTracer tracer(world);
    const auto bits = [&](Effects effects) {
        Passes passes(tracer, effects, test::bounces(3), 0);
        Progress progress("test", passes.steps(32));
        passes.add({32, Sampler::batch_size}, progress);
        std::vector<double> sums;
        for (const PixelEstimate& pixel : passes.pixels()) {
            for (const int c : {0, 1, 2}) sums.push_back(pixel.sums.radiance()[c]);
        }
        return sums;
    };
    // Choosing among lights takes the place of sampling them all, and another random number.
    constexpr Effects added{test::all_effects.bits & ~unsigned(Effect::LightChoice)};
    CHECK(effects_of(scene) != added);
    CHECK(bits(effects_of(scene)) == bits(added));
}

TEST_CASE("feature layers tell what the pixels see", "[pathtracer]") {
    Scene scene;
    scene.name = "wall";
    const int material = test::add_material(scene, {.1f, .2f, .3f});
    // A wall across the right half of the view, facing the camera.
    test::add_object(scene, Sphere{{-100.f, 0.f, 0.f}, 1.f, false, material});
    test::add_object(scene, Quad{{0.f, -9.f, -4.f}, {9.f, 0.f, 0.f}, {0.f, 18.f, 0.f}, material});
    scene.camera = {.eye = {0.f, 0.f, 1.f}, .target = glm::vec3(0.f), .width = 8, .height = 4};
    const Image image = render(scene, 0, {.spp = 16}).image;
    for (std::size_t i = 0; i < image.pixels(); ++i) {
        const bool on_wall = i % 8 >= 4;
        CHECK(image.channel("object.Y")[i] == (on_wall ? 1.f : -1.f));
        CHECK(image.channel("albedo.B")[i] == Approx(on_wall ? .3f : 0.f));
        CHECK(image.channel("normal.Z")[i] == Approx(on_wall ? 1.f : 0.f));
        CHECK(image.channel("depth.Z")[i] == Approx(on_wall ? 5.f : 0.f));
        CHECK(image.channel("samples.Y")[i] == 16.f);
    }
    CHECK(image.metadata.at("plumbline:scene") == "wall");
    CHECK(image.metadata.at("plumbline:spp") == "16");
}

TEST_CASE("one sample a pixel writes no variance that it cannot know", "[pathtracer]") {
    const RenderResult result = render(test::mixed_room(4, 4), 0, {.spp = 1});
    CHECK_FALSE(result.image.has_layer("variance"));
    CHECK(std::isnan(result.relmse_estimate));
}

TEST_CASE("values that are not finite are counted, located and shown", "[pathtracer]") {
    Scene scene = test::mixed_room(8, 8);
    scene.lights = {
        test::inverse_square({.4f, .7f, -.2f}, Spectrum(std::numeric_limits<float>::infinity()))};
    const RenderResult result = render(scene, 0, {.spp = 16});
    CHECK(result.non_finite.samples > 0);
    REQUIRE(result.non_finite.first);
    const glm::ivec2 first = *result.non_finite.first;
    const auto radiance = result.image.channel("R");
    for (int i = 0; i < first.y * 8 + first.x; ++i) CHECK(std::isfinite(radiance[std::size_t(i)]));
    CHECK_FALSE(std::isfinite(radiance[std::size_t(first.y * 8 + first.x)]));
    for (const float samples : result.image.channel("samples.Y")) CHECK(samples == 16.f);

    const RenderResult finite = render(test::mixed_room(8, 8), 0, {.spp = 16});
    CHECK(finite.non_finite.samples == 0);
    CHECK_FALSE(finite.non_finite.first);
}

}  // namespace plumbline::pathtracer
