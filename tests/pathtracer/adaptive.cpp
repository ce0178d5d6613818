// SPDX-License-Identifier: Apache-2.0
// Samples that go where the error falls most, and leave every mean and variance as they were.
#include <tbb/global_control.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <utility>

#include "pathtracer/allocation.h"
#include "pathtracer/render.h"
#include "pathtracer/sampler.h"
#include "scenes/scene_files.h"
#include "tests/pathtracer/pictures.h"
#include "tests/pathtracer/scenes.h"

namespace plumbline::pathtracer {
namespace {

constexpr int batch = Sampler::batch_size;

/// Costs that differ from half to half by up to 100, some unknown.
std::vector<HalfCost> random_costs(std::size_t halves, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> exponent(0., 2.);
    std::vector<HalfCost> costs(halves);
    for (HalfCost& cost : costs) {
        cost = {std::pow(10., exponent(random)), std::pow(10., exponent(random))};
        if (random() % 8 == 0) cost.relmse = std::nan("");
    }
    return costs;
}

double mean_samples(int colour, std::span<const Tiles::Part> halves, const std::vector<int>& n) {
    double sum = 0., pixels = 0.;
    for (std::size_t i = 0; i < halves.size(); ++i) {
        if (halves[i].colour != colour) continue;
        sum += double(n[i]) * halves[i].pixels();
        pixels += halves[i].pixels();
    }
    return sum / pixels;
}

/// Adds a batch of samples that are 1 / p with the small probability p, and else 0: their mean
/// is 1.
void add_rare_batch(PixelEstimate& pixel, std::mt19937_64& random) {
    constexpr double p = 1. / 64.;
    SampleSums group;
    group.samples = batch;
    for (int i = 0; i < batch; ++i) {
        if (random() % 64 == 0) group.direct += 1. / p;
    }
    pixel.add_group(group);
}

/// The mean of a picture of such pixels whose halves decide for each other, or for themselves.
double mean_of_rare_picture(unsigned seed, bool for_themselves) {
    constexpr int width = 8 * Tiles::side, pilot = 2 * batch;
    std::mt19937_64 random(seed);
    const auto halves = Tiles(width, 1).halves();
    std::vector<PixelEstimate> pixels(width);
    for (PixelEstimate& pixel : pixels) {
        for (int i = 0; i < pilot / batch; ++i) add_rare_batch(pixel, random);
    }
    std::vector<HalfCost> costs;
    for (const auto& half : halves) costs.push_back(cost_of(half, pixels, width, 1000));
    for (std::size_t i = 0; for_themselves && i < costs.size(); i += 2) {
        std::swap(costs[i], costs[i + 1]);
    }
    const std::vector<int> samples = allocate(pilot, halves, costs).samples(4 * pilot, halves);
    double mean = 0.;
    for (std::size_t i = 0; i < halves.size(); ++i) {
        halves[i].for_each_pixel(0, 1, [&](const glm::ivec2& at) {
            PixelEstimate& pixel = pixels[std::size_t(at.x)];
            for (int n = pilot; n < samples[i]; n += batch) add_rare_batch(pixel, random);
            mean += pixel.sums.radiance().x / pixel.sums.samples / width;
        });
    }
    return mean;
}

/// Standard errors by which the mean over many pictures misses the truth.
double z_of_rare_pictures(bool for_themselves) {
    constexpr int pictures = 1000;
    double sum = 0., sum2 = 0.;
    for (unsigned seed = 0; seed < pictures; ++seed) {
        const double error = mean_of_rare_picture(seed, for_themselves) - 1.;
        sum += error;
        sum2 += error * error;
    }
    return sum / std::sqrt(sum2 - sum * sum / pictures);
}

/// A lamp close to a wall, whose spot there few paths find, and which then shines brightly.
Scene spotted_room(int width, int height) {
    Scene scene = test::mixed_room(width, height);
    scene.lights = {test::inverse_square({.4f, .7f, -.97f}, {.6f, .5f, .4f})};
    return scene;
}

/// Sums over pictures of many seeds, of the channel G of each pixel, and of what they report.
struct OverSeeds {
    explicit OverSeeds(std::size_t pixels) : sum(pixels), sum2(pixels) {}

    void add(const RenderResult& result) {
        const auto values = result.image.layer("")[1];
        const auto variances = result.image.layer("variance")[1];
        for (std::size_t i = 0; i < sum.size(); ++i) {
            sum[i] += double(values[i]);
            sum2[i] += double(values[i]) * double(values[i]);
            reported += double(variances[i]);
        }
        ++seeds;
    }
    double mean(std::size_t i) const { return sum[i] / seeds; }
    /// Variance of one picture's pixel.
    double variance(std::size_t i) const {
        return (sum2[i] - sum[i] * sum[i] / seeds) / (seeds - 1);
    }

    std::vector<double> sum, sum2;
    double reported = 0.;
    int seeds = 0;
};

}  // namespace

TEST_CASE("allocations have the mean asked for in whole batches", "[pathtracer][adaptive]") {
    for (const auto& [width, height] : {std::pair(480, 270), {45, 37}, {33, 17}, {1, 40}}) {
        const auto halves = Tiles(width, height).halves();
        const Allocation allocation =
            allocate(64, halves, random_costs(halves.size(), unsigned(width)));
        std::vector<int> before(halves.size(), 64);
        for (const int level : {64, 80, 96, 100, 1000}) {
            const std::vector<int> n = allocation.samples(level, halves);
            for (std::size_t i = 0; i < n.size(); ++i) {
                REQUIRE(n[i] % batch == 0);
                REQUIRE(n[i] >= before[i]);
            }
            for (const int colour : {0, 1}) {
                int colour_pixels = 0, largest = 0;
                for (const auto& half : halves) {
                    if (half.colour != colour) continue;
                    colour_pixels += half.pixels();
                    largest = std::max(largest, half.pixels());
                }
                const double mean = mean_samples(colour, halves, n);
                CHECK(mean <= level);
                CHECK(mean > level - double(batch * largest) / colour_pixels);
            }
            before = n;
        }
    }
}

TEST_CASE("samples go by the root of error over rays", "[pathtracer][adaptive]") {
    // Two tiles, one of which has 9 times the relMSE a sample, or a ninth of the rays: thrice the
    // samples [Neyman 1934].
    const auto halves = Tiles(32, 16).halves();
    const std::vector<HalfCost> more_error = {{9., 2.}, {9., 2.}, {1., 2.}, {1., 2.}};
    const std::vector<HalfCost> fewer_rays = {{5., 1.}, {5., 1.}, {5., 9.}, {5., 9.}};
    for (const auto& costs : {more_error, fewer_rays}) {
        const std::vector<int> n = allocate(32, halves, costs).samples(1024, halves);
        CHECK(n == std::vector<int>{1536, 1536, 512, 512});
    }
}

TEST_CASE("a half-tile's own samples have no say in their number", "[pathtracer][adaptive]") {
    const auto halves = Tiles(100, 50).halves();
    const std::vector<HalfCost> costs = random_costs(halves.size(), 1);
    const std::vector<HalfCost> others = random_costs(halves.size(), 2);
    const std::vector<int> n = allocate(32, halves, costs).samples(200, halves);
    for (const int colour : {0, 1}) {
        std::vector<HalfCost> changed = costs;
        for (std::size_t i = 0; i < halves.size(); ++i) {
            if (halves[i].colour == colour) changed[i] = others[i];
        }
        const std::vector<int> m = allocate(32, halves, changed).samples(200, halves);
        CHECK(m != n);
        for (std::size_t i = 0; i < halves.size(); ++i) {
            if (halves[i].colour == colour) REQUIRE(m[i] == n[i]);
        }
    }
}

TEST_CASE("halves that decide for each other are unbiased and for themselves are not",
          "[pathtracer][adaptive][statistics]") {
    // A right mean misses by 4 standard errors once in 16,000 seeds; the bias of halves that decide
    // for themselves, which stop early when they saw little light, shows that the test would see
    // it.
    CHECK(std::abs(z_of_rare_pictures(false)) < 4.);
    CHECK(z_of_rare_pictures(true) < -8.);
}

TEST_CASE("adaptive pictures have the mean and the variance that they claim",
          "[pathtracer][adaptive][statistics]") {
    const std::string name = GENERATE("spotted room", "cornell-box");
    constexpr int width = 36, height = 12, spp = 64, seeds = 64;
    Scene scene = name == "spotted room" ? spotted_room(width, height) : load_scene(name);
    scene.camera.width = width;
    scene.camera.height = height;
    OverSeeds pictures(std::size_t(width * height));
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const RenderResult result =
            render(scene, 0, {.spp = spp, .max_bounces = 2, .seed = seed, .adaptive = true});
        REQUIRE(result.counts.most > result.counts.fewest);
        pictures.add(result);
    }
    const RenderResult reference = render(scene, 0, {.spp = spp * seeds / 2, .max_bounces = 2});
    const auto truth = std::as_const(reference.image).layer("")[1];
    const auto truth_variance = std::as_const(reference.image).layer("variance")[1];
    double measured = 0.;
    for (const auto& half : Tiles(width, height).halves()) {
        double difference = 0., variance = 0.;
        half.for_each_pixel(half.bounds.top, half.bounds.bottom, [&](const glm::ivec2& at) {
            const auto i = std::size_t(at.y * width + at.x);
            difference += pictures.mean(i) - double(truth[i]);
            variance += pictures.variance(i) / seeds + double(truth_variance[i]);
            measured += pictures.variance(i);
        });
        // 6 halves of 2 scenes: right code exceeds 4.5 once in 12,000 choices of seeds.
        INFO(name << ", tile " << half.tile << ", colour " << *half.colour);
        CHECK(std::abs(difference) <= 4.5 * std::sqrt(variance) + 1e-9);
    }
    INFO(name << ": " << pictures.reported / seeds << " for " << measured);
    CHECK(pictures.reported / seeds / measured == Approx(1.).margin(.1));
}

TEST_CASE("an adaptive picture has as many samples as asked and says how they lie",
          "[pathtracer][adaptive]") {
    const Scene scene = spotted_room(45, 37);
    const RenderOptions options{.spp = 100, .seed = 4, .adaptive = true};
    const auto render_with = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return render(scene, 0, options);
    };
    const RenderResult one = render_with(1), two = render_with(2);
    CHECK(test::same_pixels(one.image, two.image));
    CHECK(one.rays == two.rays);

    double sum = 0.;
    for (const float n : std::as_const(one.image).channel("samples.Y")) {
        CHECK(n >= 32.f);
        sum += double(n);
    }
    CHECK(one.spp == 100);
    CHECK(one.counts.mean == Approx(sum / double(one.image.pixels())));
    CHECK(one.counts.mean <= 100.);
    CHECK(one.counts.mean > 100. - batch * 128. / (45. * 37. / 2.));
    CHECK(one.counts.fewest >= 32);
    CHECK(one.counts.most > 100);
    CHECK_THAT(one.image.metadata.at("plumbline:adaptive"), Catch::Contains("samples a pixel"));
}

TEST_CASE("an adaptive picture reaches an error with fewer samples", "[pathtracer][adaptive]") {
    const Scene scene = spotted_room(48, 32);
    RenderOptions options{.spp = 1 << 20, .target_relmse = .02};
    const RenderResult even = render(scene, 0, options);
    options.adaptive = true;
    const RenderResult adaptive = render(scene, 0, options);
    CHECK(adaptive.relmse_estimate <= .02);
    CHECK(even.spp > 64);
    CHECK(adaptive.spp < even.spp);
}

}  // namespace plumbline::pathtracer
