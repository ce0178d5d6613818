// SPDX-License-Identifier: Apache-2.0
#include "reports/ablation.h"

#include <catch2/catch.hpp>
#include <set>
#include <stdexcept>

#include "pathtracer/render.h"
#include "reports/ablation_page.h"
#include "reports/cost_page.h"
#include "scenes/errors.h"
#include "tests/ddgi/small_scenes.h"
#include "tests/reports/page_parts.h"

using namespace plumbline;
using namespace plumbline::reports;

namespace {

const AblationRow& row_named(const AblationScene& scene, const std::string& name) {
    for (const AblationRow& row : scene.rows)
        if (row.subject.name == name) return row;
    throw std::logic_error("no case " + name);
}

}  // namespace

TEST_CASE("the ablation's cases have names of their own, and options that make them",
          "[reports][ablation]") {
    std::set<std::string> names;
    for (const AblationCase& subject : ablation_cases()) {
        CHECK(names.insert(subject.name).second);
        CHECK(subject.options.starts_with("--model "));
    }
    CHECK(names.size() >= 16);
    const auto some = ablation_cases({"sh3", "thesis"});
    REQUIRE(some.size() == 2);
    CHECK(some[0].name == "thesis");
    CHECK_THROWS_WITH(ablation_cases({"sh33"}), Catch::Contains("sh3"));
}

TEST_CASE("an ablation splits each case's error and finds the gain it lacks",
          "[reports][ablation]") {
    Scene scene = ddgi::room_with_moving_block();
    scene.camera.width = 16;
    scene.camera.height = 9;
    pathtracer::RenderOptions render;
    render.spp = 64;
    const Image truth = pathtracer::render(scene, 0, render).image;
    const AblationScene measured = measure_ablation(scene, 0, truth, ablation_cases());
    for (const AblationRow& row : measured.rows) {
        CAPTURE(row.subject.name);
        const double mse = row.metrics.rmse * row.metrics.rmse;
        CHECK(row.noise.mse_expected_from_noise + row.noise.bias_mse == Approx(mse));
        CHECK(row.rmse_with_gain <= row.metrics.rmse * (1 + 1e-9));
        CHECK(row.bytes > 0);
        CHECK(row.non_finite == 0);
    }
    CHECK(row_named(measured, "conserving-64").metrics.rmse <
          row_named(measured, "thesis").metrics.rmse);
    const AblationRow& own = row_named(measured, "conserving-64");
    const AblationRow& shared = row_named(measured, "share-500");
    CHECK(own.surfels_lit == own.surfels_hit);
    CHECK(shared.surfels_lit < own.surfels_lit / 2);
    CHECK(shared.shadow_rays < own.shadow_rays / 2);
    const std::string html = study_html(ablation_page({measured}, "plumbline ablation"));
    CHECK(page_json(html)["charts"].size() == 2);
    CHECK(html.find("{{") == std::string::npos);
    CHECK(count(ablation_csv({measured}), "\n") == measured.rows.size() + 1);
}

TEST_CASE("cost counts probes and surfels, and memory grows in proportion", "[reports][cost]") {
    const Scene scene = ddgi::room_with_moving_block();
    CostOptions options;
    options.spacings = {.19f, .095f, .0475f};
    options.repeats = 1;
    const CostStudy study = measure_cost(scene, options);
    CHECK(study.probes.points[0].probes == 11 * 11 * 11);
    CHECK(study.probes.points[2].probes == 41 * 41 * 41);
    CHECK(study.surfels.points[3].per_probe == 160);
    CHECK(study.probes.bytes->exponent == Approx(1).margin(.05));
    CHECK(study.surfels.bytes->exponent == Approx(1).margin(.2));
    CHECK(study.probes.points[2].place_ms > 0);
    CHECK(cost_json(study, "room")["probes"]["points"].size() == 3);
    options.repeats = 0;
    CHECK_THROWS_AS(measure_cost(scene, options), UsageError);
}
