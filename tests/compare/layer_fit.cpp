// SPDX-License-Identifier: Apache-2.0
#include "compare/layer_fit.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "scenes/errors.h"
#include "tests/compare/test_images.h"

using namespace plumbline;
using namespace plumbline::compare;

namespace {

/// Two layers, and a reference that is a known sum of them with noise of known variance.
struct Passes {
    Image a = noise_image(120, 90, 1, 1.f), b = noise_image(120, 90, 2, 1.f);
    Image reference{120, 90};

    explicit Passes(unsigned seed, float sigma = 0.05f) {
        std::mt19937 random(seed);
        std::normal_distribution<float> normal(0.f, sigma);
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t i = 0; i < a.pixels(); ++i) {
                reference.layer("")[c][i] =
                    1.7f * a.layer("")[c][i] + 0.4f * b.layer("")[c][i] + normal(random);
                reference.layer("variance")[c][i] = sigma * sigma;
            }
    }
    FitResult fit(Loss loss = Loss::Squares) const {
        LayerFitSettings settings;
        settings.loss = loss;
        return fit_layers({{"a", &a, ""}, {"b", &b, ""}}, reference, settings);
    }
};

}  // namespace

TEST_CASE("gains of layers are found within their standard errors", "[compare][fit]") {
    double z2 = 0;
    for (unsigned seed = 10; seed < 18; ++seed) {
        const FitResult result = Passes(seed).fit();
        REQUIRE(result.constants.size() == 2);
        z2 += std::pow((result.constants[0].value - 1.7) / result.constants[0].standard_error, 2);
        z2 += std::pow((result.constants[1].value - 0.4) / result.constants[1].standard_error, 2);
        CHECK(result.reduced_chi_square == Approx(1).margin(0.03));
        // Independent noise: the bootstrap over tiles agrees, and is not needed.
        for (const FittedConstant& gain : result.constants) {
            CHECK(gain.standard_error == gain.standard_error_covariance);
            CHECK(gain.standard_error_bootstrap ==
                  Approx(gain.standard_error_covariance).epsilon(0.35));
        }
    }
    // Chi-square with 16 degrees of freedom: outside of 4 to 37 in 0.3 % of cases.
    CHECK(z2 > 4);
    CHECK(z2 < 37);
}

TEST_CASE("errors that are shared by whole tiles widen the standard errors of gains",
          "[compare][fit]") {
    // A misfit that is the same over 9 x 9 pixels, proportional to a layer: least squares takes
    // each pixel as new evidence for it, of which there is a hundredth.
    double z2 = 0;
    for (unsigned seed = 0; seed < 8; ++seed) {
        Passes passes(seed, 0.01f);
        std::mt19937 random(100 + seed);
        std::normal_distribution<float> normal(0.f, 0.2f);
        std::vector<float> of_tile(14 * 10);
        for (float& value : of_tile) value = normal(random);
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t i = 0; i < passes.a.pixels(); ++i)
                passes.reference.layer("")[c][i] +=
                    of_tile[i / 120 / 9 * 14 + i % 120 / 9] * passes.a.layer("")[c][i];
        const FitResult result = passes.fit();
        const FittedConstant& gain = result.constants[0];
        CHECK(gain.standard_error == gain.standard_error_bootstrap);
        CHECK(gain.standard_error > 3 * gain.standard_error_covariance);
        z2 += std::pow((gain.value - 1.7) / gain.standard_error, 2);
    }
    // Chi-square with 8 degrees of freedom: outside of 1 to 24 in 0.4 % of cases.
    CHECK(z2 > 1);
    CHECK(z2 < 24);
}

TEST_CASE("a robust loss keeps gains where squares are led astray", "[compare][fit]") {
    Passes passes(3);
    for (std::size_t i = 0; i < passes.a.pixels(); i += 20)
        for (auto& channel : passes.reference.layer(""))
            channel[i] += 30.f * passes.a.layer("")[0][i];
    CHECK(std::abs(passes.fit().constants[0].value - 1.7) > 0.3);
    for (const Loss loss : {Loss::Huber, Loss::Cauchy})
        CHECK(passes.fit(loss).constants[0].value == Approx(1.7).margin(0.05));
}

TEST_CASE("layers that are the same are known by the sum of their gains only", "[compare][fit]") {
    const Passes passes(4);
    const FitResult result = fit_layers(
        {{"a", &passes.a, ""}, {"b", &passes.b, ""}, {"c", &passes.a, ""}}, passes.reference, {});
    REQUIRE(result.combinations.size() == 1);
    CHECK(result.combinations[0].expression == "a + c");
    CHECK(std::abs(result.combinations[0].value - 1.7) < 3 * result.combinations[0].standard_error);
    CHECK_FALSE(result.constants[0].identifiable);
    CHECK(result.constants[1].identifiable);
}

TEST_CASE("gains keep within their bounds and say that they reached one", "[compare][fit]") {
    const Passes passes(5);
    LayerFitSettings settings;
    settings.upper = 1.2;
    const FitResult result =
        fit_layers({{"a", &passes.a, ""}, {"b", &passes.b, ""}}, passes.reference, settings);
    CHECK(result.constants[0].value == Approx(1.2));
    CHECK_THAT(result.notes.back(), Catch::Contains("a ends at its bound 1.2"));
}
