// SPDX-License-Identifier: Apache-2.0
#include "compare/noise.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "compare/halves.h"
#include "tests/compare/test_images.h"

using namespace plumbline;
using namespace plumbline::compare;

namespace {

constexpr int width = 40;
constexpr int height = 25;

/// Two noisy pictures of a scene with a known bias between them.
struct NoisyImages {
    Image reference{width, height};
    Image test{width, height};
    double bias_mse = 0;

    /// `shared` in [0,1] is the correlation of the channels' noise.
    NoisyImages(std::mt19937& random, float bias, float shared) {
        std::normal_distribution<float> normal;
        const auto r = reference.layer(""), r_variance = reference.layer("variance");
        const auto t = test.layer(""), t_variance = test.layer("variance");
        for (std::size_t i = 0; i < reference.pixels(); ++i) {
            const float u = float(i % width) / width;
            const float r_sigma = 0.05f + 0.1f * u, t_sigma = 0.08f;
            const float common_r = normal(random), common_t = normal(random);
            for (std::size_t c = 0; c < 3; ++c) {
                const float b = bias * (0.5f + u) * (c == 1 ? 1.f : 0.6f);
                const float own = std::sqrt(1.f - shared), both = std::sqrt(shared);
                r[c][i] = 0.5f + r_sigma * (both * common_r + own * normal(random));
                t[c][i] = 0.5f + b + t_sigma * (both * common_t + own * normal(random));
                r_variance[c][i] = r_sigma * r_sigma;
                t_variance[c][i] = t_sigma * t_sigma;
                bias_mse += double(b) * double(b) / (3.0 * width * height);
            }
        }
    }
};

std::optional<NoiseSplit> split(const NoisyImages& images) {
    return split_noise(images.reference, images.test,
                       pair_layers(images.reference, images.test, ""));
}

}  // namespace

TEST_CASE("the interval of the bias covers the truth in 93 to 97 percent of trials", "[compare]") {
    const float bias = GENERATE(0.f, 0.05f, 0.3f);
    const float shared = GENERATE(0.f, 0.6f, 1.f);
    std::mt19937 random(17);
    int covered = 0;
    double mean = 0, truth = 0;
    constexpr int trials = 1000;
    for (int trial = 0; trial < trials; ++trial) {
        const NoisyImages images(random, bias, shared);
        const NoiseSplit noise = split(images).value();
        covered +=
            noise.bias_mse_ci95[0] <= images.bias_mse && images.bias_mse <= noise.bias_mse_ci95[1];
        mean += noise.bias_mse / trials;
        truth = images.bias_mse;
    }
    INFO("bias " << bias << ", channels' correlation " << shared);
    CHECK(covered >= 930);
    CHECK(covered <= 970);
    CHECK(mean == Approx(truth).margin(2e-4));
}

TEST_CASE("noise alone exceeds three standard deviations at the Gaussian rate", "[compare]") {
    std::mt19937 random(3);
    double fraction = 0;
    for (int trial = 0; trial < 50; ++trial)
        fraction += split(NoisyImages(random, 0.f, 0.f)).value().z_fraction_above_3 / 50;
    CHECK(fraction == Approx(0.0027).epsilon(0.15));
}

TEST_CASE("the noise correlation of channels is found under a smooth bias", "[compare]") {
    std::mt19937 random(5);
    const float shared = GENERATE(0.f, 0.5f, 1.f);
    double rho = 0;
    for (int trial = 0; trial < 50; ++trial)
        rho += split(NoisyImages(random, 0.3f, shared)).value().channel_correlation / 50;
    CHECK(rho == Approx(double(shared)).margin(0.05));
}

TEST_CASE("one image's variances are enough, none are not", "[compare]") {
    const Image a = noise_image(12, 12, 1, 1.f);
    Image b = noise_image(12, 12, 2, 1.f);
    CHECK_FALSE(split_noise(a, b, pair_layers(a, b, "")));
    for (auto& channel : b.layer("variance"))
        for (float& value : channel) value = 0.01f;
    const auto noise = split_noise(a, b, pair_layers(a, b, ""));
    REQUIRE(noise);
    CHECK(noise->mse_expected_from_noise == Approx(0.01));
    CHECK_FALSE(noise->reference_variance);
    CHECK(noise->test_variance);
}

TEST_CASE("pixels with an impossible variance are left out and counted", "[compare]") {
    const Image a = noise_image(12, 12, 1, 1.f);
    Image b = noise_image(12, 12, 2, 1.f);
    b.layer("variance")[0][5] = -1.f;
    b.layer("variance")[2][7] = std::nanf("");
    const auto noise = split_noise(a, b, pair_layers(a, b, ""));
    REQUIRE(noise);
    CHECK(noise->left_out == 2);
    CHECK(std::isfinite(noise->bias_mse));
}

TEST_CASE("each layer has its own variance layer", "[compare]") {
    CHECK(variance_layer("") == "variance");
    CHECK(variance_layer("indirect") == "variance_indirect");
}

TEST_CASE("the interval from halves covers the truth in 93 to 97 percent of trials", "[compare]") {
    const float bias = GENERATE(0.f, 0.05f, 0.3f);
    const float shared = GENERATE(0.f, 1.f);
    const bool reference_half = GENERATE(false, true);  // else it has variances
    std::mt19937 random(29);
    int covered = 0;
    double mean = 0, truth = 0, noise = 0;
    constexpr int trials = 1000;
    for (int trial = 0; trial < trials; ++trial) {
        const NoisyImages first(random, bias, shared), second(random, bias, shared);
        const auto [split, variance] =
            split_by_halves(first.reference, first.test,
                            {reference_half ? &second.reference : nullptr, &second.test},
                            pair_layers(first.reference, first.test, ""));
        covered +=
            split.bias_mse_ci95[0] <= first.bias_mse && first.bias_mse <= split.bias_mse_ci95[1];
        mean += split.bias_mse / trials;
        noise += split.mse_expected_from_noise / trials;
        truth = first.bias_mse;
    }
    INFO("bias " << bias << ", channels' correlation " << shared << ", half of the reference "
                 << reference_half);
    CHECK(covered >= 930);
    CHECK(covered <= 970);
    CHECK(mean == Approx(truth).margin(2e-4));
    // The mean over the width of (0.05 + 0.1 u)^2 + 0.08^2.
    CHECK(noise == Approx(0.0107708 + 0.0064).epsilon(0.03));
}

TEST_CASE("halves find the deviation of each pixel from its surroundings", "[compare]") {
    std::mt19937 random(31);
    double fraction = 0;
    for (int trial = 0; trial < 50; ++trial) {
        const NoisyImages first(random, 0.f, 0.f), second(random, 0.f, 0.f);
        const auto halves =
            split_by_halves(first.reference, first.test, {&second.reference, &second.test},
                            pair_layers(first.reference, first.test, ""));
        CHECK(halves.split.method == "independent halves");
        fraction += halves.split.z_fraction_above_3 / 50;
        const std::size_t middle = 12 * width + 20;
        CHECK(double(halves.variance[0][middle]) == Approx(0.1 * 0.1 + 0.08 * 0.08).epsilon(0.7));
    }
    // Above the Gaussian 0.0027: d is part of its own estimate of s, of 25 to 81 values.
    CHECK(fraction > 0.001);
    CHECK(fraction < 0.006);
}
