// SPDX-License-Identifier: Apache-2.0
#include "compare/metrics.h"

#include <tbb/global_control.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "compare/comparison.h"
#include "scenes/errors.h"
#include "tests/compare/test_images.h"

using namespace plumbline;
using namespace plumbline::compare;
using Catch::WithinRel;

namespace {

/// Two pixels: d is (0.5, 0, 0) and (0, -1, 0).
struct TwoPixels {
    Image reference = image_of(2, 1, [](int x, int, int) { return x == 0 ? 1.f : 2.f; });
    Image test = image_of(2, 1, [](int x, int, int c) {
        if (x == 0) return c == 0 ? 1.5f : 1.f;
        return c == 1 ? 1.f : 2.f;
    });
};

}  // namespace

TEST_CASE("metrics of two pixels equal what one computes by hand", "[compare]") {
    const TwoPixels images;
    const Metrics m = pixel_metrics(pair_layers(images.reference, images.test, ""));
    CHECK_THAT(m.bias, WithinRel(-0.5 / 6, 1e-12));
    CHECK_THAT(m.mae, WithinRel(1.5 / 6, 1e-12));
    CHECK_THAT(m.rmse, WithinRel(std::sqrt(1.25 / 6), 1e-12));
    CHECK_THAT(m.relmse, WithinRel((0.25 / 1.01 + 1.0 / 4.01) / 6, 1e-12));
    CHECK_THAT(m.smape, WithinRel((0.5 / 2.51 + 1.0 / 3.01) / 6, 1e-12));
    CHECK_THAT(m.psnr_db, WithinRel(10 * std::log10(4.0 / (1.25 / 6)), 1e-12));
}

TEST_CASE("equal images have no error", "[compare]") {
    const Image image = noise_image(20, 20, 1, 3.f);
    const Comparison comparison = compare_images(image, image, "");
    CHECK(comparison.metrics.bias == 0);
    CHECK(comparison.metrics.rmse == 0);
    CHECK(comparison.metrics.relmse == 0);
    CHECK(comparison.metrics.smape == 0);
    CHECK(comparison.metrics.psnr_db == std::numeric_limits<double>::infinity());
    CHECK_THAT(comparison.metrics.ssim.value(), WithinRel(1.0, 1e-12));
    CHECK(comparison.metrics.flip.value() == 0);
}

TEST_CASE("a pixel with a value that is not finite is counted, located and left out", "[compare]") {
    const auto bad =
        GENERATE(std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity());
    TwoPixels images;
    images.test.channel("G")[1] = bad;
    images.reference.channel("B")[1] = bad;
    const LayerPair pair = pair_layers(images.reference, images.test, "");
    CHECK(pair.non_finite == 2);
    CHECK(pair.usable_pixels == 1);
    REQUIRE(pair.first_non_finite);
    CHECK(pair.first_non_finite->x == 1);
    CHECK(pair.first_non_finite->y == 0);
    CHECK_THAT(pixel_metrics(pair).rmse, WithinRel(std::sqrt(0.25 / 3), 1e-12));
}

TEST_CASE("images that cannot be compared are refused with the reason", "[compare]") {
    const Image a = noise_image(4, 3, 1, 1.f), b = noise_image(3, 4, 2, 1.f);
    CHECK_THROWS_WITH(compare_images(a, b, ""), Catch::Contains("3x4") && Catch::Contains("4x3"));
    CHECK_THROWS_WITH(compare_images(a, a, "indirect"), Catch::Contains("no layer 'indirect'"));
    const Image nan = image_of(2, 2, [](int, int, int) { return std::nanf(""); });
    CHECK_THROWS_AS(compare_images(nan, nan, ""), ImageError);
}

TEST_CASE("a comparison has the same bits at any thread count", "[compare]") {
    const Image a = noise_image(300, 130, 1, 2.f), b = noise_image(300, 130, 2, 2.f);
    const auto compare_with = [&](std::size_t threads) {
        tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return compare_images(a, b, "");
    };
    const Comparison one = compare_with(1), two = compare_with(2);
    for (const MetricDescription& metric : metric_descriptions())
        CHECK(metric.value(one.metrics).value() == metric.value(two.metrics).value());
}
