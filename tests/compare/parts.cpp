// SPDX-License-Identifier: Apache-2.0
#include "compare/parts.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>

#include "compare/comparison.h"
#include "scenes/errors.h"
#include "tests/compare/test_images.h"

using namespace plumbline;
using namespace plumbline::compare;

TEST_CASE("channels and objects and mask are measured on their own", "[compare]") {
    Image r = image_of(20, 20, [](int, int, int) { return 1.f; });
    // Object 3 (columns from 10) is too bright by 0.2 in green alone, object 1 too dark by 0.1.
    const Image t = image_of(20, 20, [](int x, int, int c) {
        return x < 10 ? 0.9f : c == 1 ? 1.2f : 1.f;
    });
    for (std::size_t i = 0; i < r.pixels(); ++i) r.channel("object.Y")[i] = i % 20 < 10 ? 1.f : 3.f;

    const Comparison all = compare_images(r, t, "");
    REQUIRE(all.channel_metrics.size() == 3);
    CHECK(all.channels[1] == "G");
    CHECK(all.channel_metrics[0].bias == Approx(-0.05));
    CHECK(all.channel_metrics[1].bias == Approx(0.05));
    CHECK(all.channel_metrics[1].rmse == Approx(std::sqrt((0.01 + 0.04) / 2)));

    REQUIRE(all.objects.size() == 2);
    CHECK(all.objects[0].object == 3);
    CHECK(all.objects[0].pixels == 200);
    CHECK(all.objects[0].share == Approx(0.04 / (0.04 + 0.03)));
    CHECK(all.objects[1].metrics.bias == Approx(-0.1));
    const double flip = 0.5 * (*all.objects[0].metrics.flip + *all.objects[1].metrics.flip);
    CHECK(flip == Approx(*all.metrics.flip));

    const Image mask = image_of(20, 20, [](int x, int, int) { return x < 10 ? 1.f : 0.f; });
    ComparisonOptions options;
    options.mask = &mask;
    const Comparison inside = compare_images(r, t, "", options);
    CHECK(inside.counted_pixels == 200);
    CHECK(inside.metrics.bias == Approx(-0.1));
    CHECK(*inside.metrics.flip == Approx(*all.objects[1].metrics.flip));
    CHECK(inside.objects.size() == 1);
    const Image nothing = image_of(20, 20, [](int, int, int) { return 0.f; });
    options.mask = &nothing;
    CHECK_THROWS_WITH(compare_images(r, t, "", options), Catch::Contains("inside the mask"));
}

TEST_CASE("a layer of one channel is measured once", "[compare]") {
    Image r(12, 12), t(12, 12);
    for (float& depth : t.channel("depth.Z")) depth = 2.f;
    r.channel("depth.Z");
    const Comparison comparison = compare_images(r, t, "depth");
    CHECK(comparison.channels == std::vector<std::string>{"depth.Z"});
    CHECK(comparison.metrics.rmse == Approx(2));
}

TEST_CASE("percentiles say which share of the error a few pixels hold", "[compare]") {
    const Image r = image_of(10, 10, [](int, int, int) { return 0.f; });
    // Errors 1 to 99 in a hundred steps of a pixel, and one firefly.
    const Image t = image_of(
        10, 10, [](int x, int y, int) { return x + y == 18 ? 1000.f : float(10 * y + x + 1); });
    const auto curve = error_percentiles(pair_layers(r, t, ""));
    const auto at = [&](double percent) {
        for (const ErrorPercentile& one : curve)
            if (one.percent == percent) return one;
        throw std::out_of_range("percent");
    };
    CHECK(at(50).error == 50);
    CHECK(at(99).error == 99);
    CHECK(at(100).error == 1000);
    CHECK(at(100).share_above == 0);
    const double squares = 99.0 * 100 * 199 / 6;
    CHECK(at(99).share_above == Approx(1e6 / (1e6 + squares)));
    CHECK(at(1).share_above == Approx((1e6 + squares - 1) / (1e6 + squares)));
}

TEST_CASE("ssim counts windows whose middle lies inside the mask", "[compare]") {
    const Image r = noise_image(40, 20, 1, 1.f);
    Image t = r;
    for (auto& channel : t.layer(""))
        for (std::size_t i = 0; i < channel.size(); ++i)
            if (i % 40 >= 26) channel[i] = 0.5f;
    // The left half is 6 columns away from what changed, farther than a window reaches.
    const Image mask = image_of(40, 20, [](int x, int, int) { return x < 20 ? 1.f : 0.f; });
    ComparisonOptions options;
    options.mask = &mask;
    CHECK(*compare_images(r, t, "", options).metrics.ssim == Approx(1));
    CHECK(*compare_images(r, t, "").metrics.ssim < 0.9);
}
