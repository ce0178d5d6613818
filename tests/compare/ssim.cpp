// SPDX-License-Identifier: Apache-2.0
#include "compare/ssim.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/compare/test_images.h"

using namespace plumbline;
using namespace plumbline::compare;
using Catch::WithinAbs;

namespace {

double luma(const Image& image, int x, int y) {
    const auto layer = image.layer("");
    const std::size_t i = std::size_t(y * image.width() + x);
    const auto encoded = [&](std::size_t c) {
        return double(srgb_from_linear(std::min(1.f, std::max(0.f, layer[c][i]))));
    };
    return 0.2126 * encoded(0) + 0.7152 * encoded(1) + 0.0722 * encoded(2);
}

/// SSIM of one window by its definition: weighted means, then central moments around them.
double window_ssim(const Image& a, const Image& b, int left, int top) {
    double weights = 0, ma = 0, mb = 0, va = 0, vb = 0, cov = 0;
    for (const bool moments : {false, true}) {
        for (int y = 0; y < 11; ++y)
            for (int x = 0; x < 11; ++x) {
                const double w =
                    std::exp(-((x - 5) * (x - 5) + (y - 5) * (y - 5)) / (2 * 1.5 * 1.5));
                const double pa = luma(a, left + x, top + y), pb = luma(b, left + x, top + y);
                if (moments) {
                    va += w * (pa - ma) * (pa - ma) / weights;
                    vb += w * (pb - mb) * (pb - mb) / weights;
                    cov += w * (pa - ma) * (pb - mb) / weights;
                } else {
                    weights += w;
                    ma += w * pa;
                    mb += w * pb;
                }
            }
        if (!moments) {
            ma /= weights;
            mb /= weights;
        }
    }
    const double c1 = 1e-4, c2 = 9e-4;
    return (2 * ma * mb + c1) * (2 * cov + c2) / ((ma * ma + mb * mb + c1) * (va + vb + c2));
}

}  // namespace

TEST_CASE("ssim equals its definition window by window", "[compare]") {
    const Image a = noise_image(17, 14, 1, 1.2f), b = noise_image(17, 14, 2, 1.2f);
    double sum = 0;
    for (int top = 0; top <= 14 - 11; ++top)
        for (int left = 0; left <= 17 - 11; ++left) sum += window_ssim(a, b, left, top);
    const double expected = sum / (4 * 7);
    CHECK_THAT(ssim(pair_layers(a, b, "")).value(), WithinAbs(expected, 1e-6));
}

TEST_CASE("ssim of two flat images is its luminance term", "[compare]") {
    const Image a = image_of(12, 11, [](int, int, int) { return linear_from_srgb(0.25f); });
    const Image b = image_of(12, 11, [](int, int, int) { return linear_from_srgb(0.75f); });
    const double expected = (2 * 0.25 * 0.75 + 1e-4) / (0.25 * 0.25 + 0.75 * 0.75 + 1e-4);
    CHECK_THAT(ssim(pair_layers(a, b, "")).value(), WithinAbs(expected, 1e-5));
}

TEST_CASE("ssim of a picture smaller than its window is undefined", "[compare]") {
    const Image a = noise_image(10, 30, 1, 1.f);
    CHECK_FALSE(ssim(pair_layers(a, a, "")));
}
