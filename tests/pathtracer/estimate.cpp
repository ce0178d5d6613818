// SPDX-License-Identifier: Apache-2.0
// What a picture says of its own error, against errors measured.
#include "pathtracer/estimate.h"

#include <catch2/catch.hpp>
#include <vector>

#include "pathtracer/render.h"
#include "tests/pathtracer/scenes.h"

namespace plumbline::pathtracer {
namespace {

/// Mean over pixels of the variance across seeds, and of the variance reported.
struct Variances {
    double measured = 0.;
    double reported = 0.;
};

Variances variances(const std::string& layer, const std::string& variance_layer, int spp) {
    constexpr int seeds = 64;
    const Scene scene = test::mixed_room(10, 8);
    std::vector<double> sum, sum2;
    Variances result;
    for (int seed = 0; seed < seeds; ++seed) {
        const RenderResult picture =
            render(scene, 0, {.spp = spp, .seed = static_cast<std::uint64_t>(seed)});
        const auto values = picture.image.layer(layer)[1];
        const auto reported = picture.image.layer(variance_layer)[1];
        sum.resize(values.size());
        sum2.resize(values.size());
        for (std::size_t i = 0; i < values.size(); ++i) {
            const double value = values[i];
            sum[i] += value;
            sum2[i] += value * value;
            result.reported += double(reported[i]) / double(values.size() * seeds);
        }
    }
    for (std::size_t i = 0; i < sum.size(); ++i) {
        result.measured += (sum2[i] - sum[i] * sum[i] / seeds) / (seeds - 1) / double(sum.size());
    }
    return result;
}

/// Root mean square of the difference of two pictures' means over blocks, per picture.
double block_error(const Image& a, const Image& b, int block) {
    double sum = 0.;
    int blocks = 0;
    const auto va = a.layer("indirect")[1];
    const auto vb = b.layer("indirect")[1];
    for (int y = 0; y + block <= a.height(); y += block) {
        for (int x = 0; x + block <= a.width(); x += block) {
            double difference = 0.;
            for (int i = 0; i < block * block; ++i) {
                const auto pixel = std::size_t(y + i / block) * std::size_t(a.width()) +
                                   std::size_t(x + i % block);
                difference += double(va[pixel]) - double(vb[pixel]);
            }
            difference /= block * block;
            sum += difference * difference;
            ++blocks;
        }
    }
    return std::sqrt(sum / blocks / 2.);
}

}  // namespace

TEST_CASE("the variance layers agree with the variance over 64 seeds", "[pathtracer][statistics]") {
    const Variances radiance = variances("", "variance", 64);
    CHECK(radiance.reported / radiance.measured == Approx(1.).margin(.1));
    const Variances indirect = variances("indirect", "variance_indirect", 64);
    CHECK(indirect.reported / indirect.measured == Approx(1.).margin(.1));
}

TEST_CASE("with fewer than two batches the variance reported is not too small",
          "[pathtracer][statistics]") {
    const Variances radiance = variances("", "variance", 16);
    CHECK(radiance.reported / radiance.measured > .95);
    CHECK(radiance.reported / radiance.measured < 4.);
}

TEST_CASE("the error of block means halves with each doubling of block and of sqrt(spp)",
          "[pathtracer][statistics]") {
    const Scene scene = test::mixed_room(96, 96);
    const auto picture = [&](int spp, std::uint64_t seed) {
        return render(scene, 0, {.spp = spp, .seed = seed}).image;
    };
    const Image a = picture(16, 1), b = picture(16, 2);
    const Image a4 = picture(64, 3), b4 = picture(64, 4);
    const double pixel = block_error(a, b, 1);
    for (const int block : {2, 4, 8}) {
        // 144 blocks of 8 x 8 tell their spread to 6 %.
        CHECK(block_error(a, b, block) * block / pixel == Approx(1.).margin(.2));
        CHECK(block_error(a4, b4, block) * 2 * block / pixel == Approx(1.).margin(.2));
    }
}

TEST_CASE("groups of unequal size are weighted by their samples", "[pathtracer][statistics]") {
    const auto group = [](double value, unsigned samples) {
        SampleSums sums;
        sums.direct = glm::dvec3(value * samples);
        sums.samples = samples;
        return sums;
    };
    PixelEstimate estimate;
    CHECK(std::isnan(estimate.radiance_variance().x));
    estimate.add_group(group(1., 16));
    CHECK(std::isnan(estimate.radiance_variance().x));
    estimate.add_group(group(4., 16));
    estimate.add_group(group(2., 8));
    // Mean (16 + 64 + 16) / 40 = 2.4; sum of n (x - mean)^2 = 16 1.96 + 16 2.56 + 8 .16 = 73.6.
    CHECK(estimate.sums.radiance().x / 40. == Approx(2.4));
    CHECK(estimate.radiance_variance().x == Approx(73.6 / 2. / 40.));
    CHECK(estimate.indirect_variance().x == 0.);
}

}  // namespace plumbline::pathtracer
