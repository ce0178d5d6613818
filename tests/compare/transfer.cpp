// SPDX-License-Identifier: Apache-2.0
#include "compare/transfer.h"

#include <catch2/catch.hpp>

#include "reports/hard_scenes.h"
#include "tests/compare/fit_scene.h"

using namespace plumbline;
using namespace plumbline::compare;

TEST_CASE("several scenes share constants, and each fit is tested on the others",
          "[compare][fit]") {
    const Scene a = small_scene();
    Scene b = small_scene();
    b.name = "other";
    b.lights[0].position.x += 90;
    const Image truth_a = synthetic_truth(a, {2000, 0.105, 18000, 0}, 0.01f, 7);
    const Image truth_b = synthetic_truth(b, {2000, 0.105, 9000, 0}, 0.01f, 8);
    const FitResult result = fit({{&a, 0, &truth_a}, {&b, 0, &truth_b}});
    REQUIRE(result.transfer.size() == 4);
    for (const TransferError& error : result.transfer)
        if (error.fitted_on == error.tested_on)
            CHECK(error.rmse == Approx(0.0104).epsilon(0.05));
        else
            CHECK(error.rmse > 0.02);
    CHECK(constant(result, "probeBrightness").value > 9300);
    CHECK(constant(result, "probeBrightness").value < 17700);
}

TEST_CASE("constants fitted to a scene fit it in another unit of length", "[compare][fit]") {
    const Scene scene = small_scene();
    // Above one unit: nearer surfels are published to shine as if they were that far away.
    Scene in_inches = reports::scaled_and_moved(scene, 2.54f, glm::vec3(0.f));
    in_inches.name = "in inches";
    const Constants<double> constants{2000, 0.105, 18000, 0};
    const Image truth = synthetic_truth(scene, constants, 0.01f, 7);
    const std::vector<FitCase> cases{{&scene, 0, &truth}, {&in_inches, 0, &truth}};
    const std::vector<TransferError> errors = transfer_errors(cases, {});
    REQUIRE(errors.size() == 4);
    for (const TransferError& error : errors) {
        CAPTURE(error.fitted_on, error.tested_on);
        CHECK(error.rmse == Approx(0.011).epsilon(0.1));
    }
    // Shared, they are one: each scene has them in its own unit.
    const FitResult shared = fit(cases);
    CHECK(shared.rmse_after == Approx(0.011).epsilon(0.1));
    const double falloff = constant(shared, "falloffRegulator").value;
    CHECK(falloff == Approx(2000).epsilon(0.02));
    CHECK(shared.case_constants[1].at("falloffRegulator") == Approx(falloff * 2.54 * 2.54));
    CHECK(shared.case_constants[1].at("bounceAttenuation") ==
          Approx(shared.case_constants[0].at("bounceAttenuation")));
}
