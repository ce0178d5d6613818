// SPDX-License-Identifier: Apache-2.0
#include "compare/fit.h"

#include <ceres/jet.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <memory>

#include "compare/thesis_prediction.h"
#include "ddgi/render.h"
#include "scenes/errors.h"
#include "tests/compare/fit_scene.h"

using namespace plumbline;
using namespace plumbline::compare;

TEST_CASE("the fit's picture is the renderer's", "[compare][fit]") {
    const Scene scene = small_scene();
    ddgi::DdgiOptions options;
    options.model = "thesis";
    options.updates = 200;
    const Image rendered = ddgi::render(scene, 0, options).image;
    const ThesisPicture picture(scene, 0, width, height);
    const auto fitted = picture.indirect<double>(picture.published(), every_pixel());
    const auto indirect = rendered.layer("indirect");
    double largest = 0;
    for (double value : fitted) largest = std::max(largest, value);
    REQUIRE(largest > 0.01);
    for (std::size_t i = 0; i < rendered.pixels(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            REQUIRE(fitted[i * 3 + c] ==
                    Approx(double(indirect[c][i])).margin(1e-5 * largest).epsilon(1e-5));
}

TEST_CASE("derivatives of the residuals equal finite differences", "[compare][fit]") {
    const Scene scene = small_scene();
    // At the second point lit surfels are clamped: the derivatives must know.
    const Constants<double> at =
        GENERATE(Constants<double>{2500, 0.1, 6000, 0}, Constants<double>{1000, 2.1, 2000, 0});
    const Image truth = synthetic_truth(scene, {2000, 0.2, 9000, 0}, 0.01f, 1);
    const Observations observations(FitCase{&scene, 0, &truth});
    const ThesisPrediction prediction({&observations, 1}, {{0, 1, 2, 3}}, {{1, 1, 1, 1}}, false);
    const std::vector<double> point(at.begin(), at.end());
    Jacobian jacobian;
    const std::vector<double> values = prediction.predict(point, &jacobian);
    CHECK(values == prediction.predict(point, nullptr));
    for (int k = 0; k < 3; ++k) {
        const double step = 1e-4 * at[std::size_t(k)];
        std::vector<double> above = point, below = point;
        above[std::size_t(k)] += step;
        below[std::size_t(k)] -= step;
        const auto up = prediction.predict(above, nullptr),
                   down = prediction.predict(below, nullptr);
        double largest = 0, error = 0;
        for (std::size_t i = 0; i < values.size(); ++i) {
            const double slope = jacobian(Eigen::Index(i), k);
            largest = std::max(largest, std::abs(slope));
            error = std::max(error, std::abs(slope - (up[i] - down[i]) / (2 * step)));
        }
        INFO("constant " << constant_names[std::size_t(k)]);
        CHECK(largest > 0);
        CHECK(error < 1e-4 * largest);
    }
}

TEST_CASE("a fit recovers the constants of a synthetic truth within its standard errors",
          "[compare][fit]") {
    const Scene scene = small_scene();
    const Constants<double> true_constants{2000, 0.105, 18000, 0};
    double falloff_z2 = 0, product_z2 = 0;
    constexpr int trials = 8;
    for (unsigned seed = 0; seed < trials; ++seed) {
        const Image truth = synthetic_truth(scene, true_constants, 0.02f, seed);
        const FitResult result = fit({{&scene, 0, &truth}});
        const FittedConstant& falloff = constant(result, "falloffRegulator");
        REQUIRE(falloff.identifiable);
        REQUIRE(result.combinations.size() == 1);
        const KnownCombination& product = result.combinations[0];
        falloff_z2 += std::pow((falloff.value - 2000) / falloff.standard_error, 2);
        product_z2 += std::pow((product.value - 0.105 * 18000) / product.standard_error, 2);
        CHECK(falloff.standard_error < 20);
        CHECK(product.standard_error < 20);
        CHECK(result.reduced_chi_square == Approx(1).margin(0.1));
        CHECK(result.rmse_after < 0.7 * result.rmse_before);
    }
    // Sums of eight squared standard Gaussians: below 20 in 99 % of cases, above 1.6 as often.
    CHECK(falloff_z2 < 20);
    CHECK(product_z2 < 20);
    CHECK(falloff_z2 > 1.6);
    CHECK(product_z2 > 1.6);
}

TEST_CASE("factors that act only as a product are called not identifiable", "[compare][fit]") {
    const Scene scene = small_scene();
    const Image truth = synthetic_truth(scene, {2000, 0.105, 18000, 0}, 0.01f, 3);
    const FitResult result = fit({{&scene, 0, &truth}});
    for (const char* name : {"bounceAttenuation", "probeBrightness"}) {
        CHECK_FALSE(constant(result, name).identifiable);
        CHECK(std::isinf(constant(result, name).standard_error));
    }
    CHECK(constant(result, "bounceAttenuation").value == Approx(0.105));  // kept as published
    CHECK(result.combinations.at(0).expression == "bounceAttenuation x probeBrightness");
    REQUIRE_FALSE(result.notes.empty());
    CHECK_THAT(result.notes[0], Catch::Contains("only as their product"));
}

TEST_CASE("where surfels are clamped, factors can be told apart", "[compare][fit]") {
    Scene scene = small_scene();
    // Of surfaces with albedo 1 the clamp takes some light from 1 on, of all from 1.43 on.
    scene.thesis->bounceAttenuation = 1.5f;
    const Image truth = synthetic_truth(scene, {2000, 1.6, 900, 0}, 0.005f, 4);
    const FitResult result = fit({{&scene, 0, &truth}});
    CHECK(result.combinations.empty());
    const FittedConstant& attenuation = constant(result, "bounceAttenuation");
    const FittedConstant& brightness = constant(result, "probeBrightness");
    REQUIRE(attenuation.identifiable);
    REQUIRE(brightness.identifiable);
    CHECK(std::abs(attenuation.value - 1.6) < 3 * attenuation.standard_error);
    CHECK(std::abs(brightness.value - 900) < 3 * brightness.standard_error);
}

TEST_CASE("the best gain is the least-squares scale of the published picture", "[compare][fit]") {
    const Scene scene = small_scene();
    Constants<double> brighter = ThesisPicture(scene, 0, width, height).published();
    brighter[2] *= 7;
    const Image truth = synthetic_truth(scene, brighter, 0.01f, 5);
    const FitResult result = fit({{&scene, 0, &truth}});
    CHECK(std::abs(result.gain - 7) < 3 * result.gain_standard_error);
    CHECK(result.gain_standard_error < 0.02);
    CHECK(result.rmse_gain == Approx(0.0104).epsilon(0.05));  // the noise that was added
}

TEST_CASE("a misfit that noise does not explain raises chi-square and widens errors",
          "[compare][fit]") {
    const Scene scene = small_scene();
    Image truth = synthetic_truth(scene, {2000, 0.105, 18000, 0}, 0.01f, 6);
    const FitResult exact = fit({{&scene, 0, &truth}});
    CHECK(exact.misfit < 0.003);
    for (auto& channel : truth.layer("indirect"))
        for (std::size_t i = 0; i < channel.size(); ++i)
            channel[i] += i % width < 20 ? 0.1f : -0.1f;
    const FitResult wrong = fit({{&scene, 0, &truth}});
    CHECK(wrong.reduced_chi_square > 20);
    CHECK(wrong.misfit == Approx(0.1).epsilon(0.3));
    CHECK(constant(wrong, "falloffRegulator").standard_error >
          3 * constant(exact, "falloffRegulator").standard_error);
    CHECK(wrong.rmse_after <= wrong.rmse_gain * 1.0001);
}

TEST_CASE("a fit to nothing is refused", "[compare][fit]") {
    const Scene scene = small_scene();
    CHECK_THROWS_AS(fit({}), FitError);
    const Image none(width, height);
    CHECK_THROWS_WITH(fit({{&scene, 0, &none}}), Catch::Contains("no layer 'indirect'"));
    Image black(width, height);
    black.layer("indirect");
    black.layer("variance_indirect");
    CHECK_THROWS_WITH(fit({{&scene, 0, &black}}), Catch::Contains("black"));
}

TEST_CASE("only the free constants move and scenes may have their own", "[compare][fit]") {
    const Scene a = small_scene();
    Scene b = small_scene();
    b.name = "other";
    b.lights[0].position.x += 90;
    const double published = ThesisPicture(a, 0, width, height).published()[2];
    const Constants<double> a_true{2200, 0.105, 1.5 * published, 0};
    const Constants<double> b_true{2200, 0.105, 0.5 * published, 0};
    const Image truth_a = synthetic_truth(a, a_true, 0.01f, 7);
    const Image truth_b = synthetic_truth(b, b_true, 0.01f, 8);
    FitSettings settings;
    settings.free = {"falloffRegulator", "probeBrightness"};
    settings.per_scene = {"probeBrightness"};
    const FitResult result = fit({{&a, 0, &truth_a}, {&b, 0, &truth_b}}, settings);
    REQUIRE(result.constants.size() == 3);
    CHECK(result.constants[0].scene.empty());
    CHECK(std::abs(result.constants[0].value - 2200) < 3 * result.constants[0].standard_error);
    CHECK(result.constants[1].scene == a.name);
    CHECK(std::abs(result.constants[1].value - 1.5 * published) <
          3 * result.constants[1].standard_error);
    CHECK(std::abs(result.constants[2].value - 0.5 * published) <
          3 * result.constants[2].standard_error);
    for (const FittedConstant& one : result.constants) CHECK(one.identifiable);
    CHECK(result.reduced_chi_square == Approx(1).margin(0.1));
    CHECK(result.converged);

    settings.free = {"falloff"};
    CHECK_THROWS_WITH(fit({{&a, 0, &truth_a}}, settings), Catch::Contains("no constant 'falloff'"));
    settings.free = {"falloffRegulator"};
    CHECK_THROWS_WITH(fit({{&a, 0, &truth_a}}, settings), Catch::Contains("is not free"));
}

TEST_CASE("the derivative in the feedback's constant equals finite differences", "[compare][fit]") {
    Scene scene = small_scene();
    scene.probes->spacing *= 2;
    scene.probes->counts = (scene.probes->counts - 1) / 2 + 1;
    const Image truth = synthetic_truth(small_scene(), {2000, 0.2, 9000, 0}, 0.01f, 1);
    const Observations observations(FitCase{&scene, 0, &truth});
    const ThesisPrediction prediction({&observations, 1}, {{0, 1, 2, 3}}, {{1, 1, 1, 1}}, true);
    const double at = GENERATE(0.0, 1.0);
    Jacobian jacobian;
    const auto values = prediction.predict({6000, 0.2, 9000, at}, &jacobian);
    // Surfels without light cannot go below 0: at 0 only the derivative to the right exists.
    const double step = 1e-4, below = at > 0 ? step : 0;
    const auto up = prediction.predict({6000, 0.2, 9000, at + step}, nullptr);
    const auto down = prediction.predict({6000, 0.2, 9000, at - below}, nullptr);
    double largest = 0, error = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double slope = jacobian(Eigen::Index(i), 3);
        largest = std::max(largest, std::abs(slope));
        error = std::max(error, std::abs(slope - (up[i] - down[i]) / (step + below)));
    }
    CHECK(largest > 0);
    CHECK(error < 1e-3 * largest);
}

TEST_CASE("robust losses are squares for small residuals and grow as published for large ones",
          "[compare][fit]") {
    for (const Loss loss : {Loss::Squares, Loss::Huber, Loss::Cauchy})
        for (const double r : {-40.0, -2.0, -0.3, 1e-9, 0.3, 1.3, 2.0, 40.0}) {
            const double h = 1e-6 * std::abs(r);
            const double slope = (robust(loss, r + h).value - robust(loss, r - h).value) / (2 * h);
            CHECK(robust(loss, r).slope == Approx(slope).epsilon(1e-4));
        }
    CHECK(std::pow(robust(Loss::Huber, -10).value, 2) == Approx(2 * 1.345 * 10 - 1.345 * 1.345));
    CHECK(std::pow(robust(Loss::Cauchy, 10).value, 2) ==
          Approx(2.3849 * 2.3849 * std::log(1 + 100 / (2.3849 * 2.3849))));
    CHECK(robust(Loss::Cauchy, 0).slope == 1);
}
