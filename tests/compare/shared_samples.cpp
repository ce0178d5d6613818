// SPDX-License-Identifier: Apache-2.0
#include "compare/shared_samples.h"

#include <catch2/catch.hpp>
#include <string>

#include "compare/comparison.h"
#include "scenes/errors.h"
#include "tests/compare/test_images.h"

using namespace plumbline;
using namespace plumbline::compare;

namespace {

/// As a path-traced picture of this seed has it in its header, with a variance of .01.
Image traced(unsigned values, const std::string& seed) {
    Image image = noise_image(12, 12, values, 1.f);
    image.source = "of seed " + seed;
    image.metadata = {{"plumbline:renderer", "pathtracer"},
                      {"plumbline:digest", "0123456789abcdef"},
                      {"plumbline:frame", "3"},
                      {"plumbline:size", "12x12"},
                      {"plumbline:seed", seed}};
    for (auto& channel : image.layer("variance"))
        for (float& value : channel) value = .01f;
    return image;
}

}  // namespace

TEST_CASE("pictures of one seed, scene and frame share samples, others do not", "[compare]") {
    const Image a = traced(1, "0");
    CHECK(share_samples(a, traced(2, "0")));
    CHECK_FALSE(share_samples(a, traced(2, "1")));
    const auto key =
        GENERATE(as<std::string>(), "plumbline:frame", "plumbline:digest", "plumbline:renderer");
    Image other = traced(2, "0");
    other.metadata[key] = "other";
    CHECK_FALSE(share_samples(a, other));
    CHECK_FALSE(share_samples(noise_image(12, 12, 1, 1.f), noise_image(12, 12, 2, 1.f)));
}

TEST_CASE("noise of shared samples is the difference of the variances", "[compare]") {
    const Image reference = traced(1, "0");
    Image test = traced(2, "0");
    for (auto& channel : test.layer("variance"))
        for (float& value : channel) value = .04f;
    const Comparison shared = compare_images(reference, test, "");
    REQUIRE(shared.noise);
    CHECK(shared.noise->shared_samples);
    CHECK(shared.noise->mse_expected_from_noise == Approx(.03));
    CHECK(compare_images(test, reference, "").noise->mse_expected_from_noise == Approx(.03));
    test.metadata["plumbline:seed"] = "1";
    const Comparison independent = compare_images(reference, test, "");
    REQUIRE(independent.noise);
    CHECK_FALSE(independent.noise->shared_samples);
    CHECK(independent.noise->mse_expected_from_noise == Approx(.05));
    CHECK(independent.noise->mse_overstated == 0.);
}

TEST_CASE("a half must be independent of every other picture", "[compare]") {
    const Image reference = traced(1, "0"), test = traced(2, "1"), again = traced(3, "2");
    ComparisonOptions options;
    options.halves.test = &again;
    CHECK(compare_images(reference, test, "", options).noise);
    for (const Image* half : {&test, &reference}) {
        options.halves.test = half;
        CHECK_THROWS_WITH(compare_images(reference, test, "", options),
                          Catch::Contains("its noise is that of " + half->source));
    }
    options.halves.test = &again;
    CHECK_THROWS_WITH(compare_images(reference, traced(2, "0"), "", options),
                      Catch::Contains("its noise is that of " + reference.source));
    options.halves = {&again, &again};
    CHECK_THROWS_AS(compare_images(reference, test, "", options), ImageError);
}

TEST_CASE("the interval allows for bias where variances overstate", "[compare]") {
    const Image reference = traced(1, "0");
    Image test = traced(2, "1");
    const NoiseSplit exact = compare_images(reference, test, "").noise.value();
    test.metadata["plumbline:variance"] = "of the mean, from single samples (conservative)";
    const NoiseSplit overstated = compare_images(reference, test, "").noise.value();
    CHECK(overstated.mse_overstated == Approx(.01));
    CHECK(overstated.bias_mse == exact.bias_mse);
    CHECK(overstated.bias_mse_ci95[0] == exact.bias_mse_ci95[0]);
    CHECK(overstated.bias_mse_ci95[1] == Approx(exact.bias_mse_ci95[1] + .01));

    const Image again = traced(3, "2");
    ComparisonOptions options;
    options.halves.reference = &again;
    const NoiseSplit halves = compare_images(reference, test, "", options).noise.value();
    CHECK(halves.mse_overstated == Approx(.01));
    CHECK(halves.bias_mse_ci95[1] - halves.bias_mse ==
          Approx(halves.bias_mse - halves.bias_mse_ci95[0] + .01));
}
