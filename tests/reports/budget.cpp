// SPDX-License-Identifier: Apache-2.0
#include "reports/budget.h"

#include <catch2/catch.hpp>

#include "reports/budget_page.h"
#include "scenes/errors.h"
#include "tests/ddgi/small_scenes.h"
#include "tests/reports/page_parts.h"

using namespace plumbline;
using namespace plumbline::reports;

TEST_CASE("a study of budgets plays the motion and keeps to each budget", "[reports][budget]") {
    Scene scene = ddgi::room_with_moving_block();
    scene.camera.width = 16;
    scene.camera.height = 9;
    BudgetOptions options;
    options.budgets = {60, 1'000'000};
    options.truth_spp = 32;
    options.truths = 3;
    const BudgetStudy study = measure_budget(scene, options);
    CHECK(study.first == 2);
    CHECK(study.last == 6);
    CHECK(study.frames.front() == 2);
    CHECK(study.frames.back() == 7);
    CHECK(study.held == std::vector<int>{3, 5, 7});
    REQUIRE(study.runs.size() == 3);
    CHECK_FALSE(study.runs[0].budget);
    const BudgetRun& tight = study.runs[1];
    for (const BudgetFrame& frame : tight.frames) CHECK(frame.replaced <= 60);
    CHECK(tight.frames.back().waiting > 0);
    CHECK(tight.frames.back().oldest_wait > 1);
    CHECK(tight.frames.front().lag == 0.);
    CHECK(tight.frames.back().lag > 0.);
    // A budget that is never spent is none.
    for (std::size_t i = 0; i < study.frames.size(); ++i) {
        CHECK(study.runs[2].frames[i].lag == 0.);
        CHECK(study.runs[2].frames[i].replaced == study.runs[0].frames[i].replaced);
    }
    CHECK(study.runs[2].errors[1].rmse == study.runs[0].errors[1].rmse);

    const auto json = budget_json(study);
    CHECK(json["budgets"][0]["budget"].is_null());
    CHECK(json["budgets"][1]["frames_to_settle"].is_null());
    CHECK(json["budgets"][2]["frames_to_settle"] == 0);
    CHECK(count(budget_csv(study), "\n") == 3 * study.frames.size() + 1);
    const std::string html = study_html(budget_page(study, "room", "plumbline budget room"));
    CHECK(page_json(html)["charts"].size() == 5);
    CHECK(html.find("{{") == std::string::npos);
}

TEST_CASE("budgets of scenes at rest, or of nothing, are refused", "[reports][budget]") {
    CHECK_THROWS_WITH(measure_budget(ddgi::closed_room(Spectrum(.5f), Spectrum(1.f)), {}),
                      Catch::Contains("moves"));
    BudgetOptions options;
    options.budgets = {0};
    CHECK_THROWS_AS(measure_budget(ddgi::room_with_moving_block(), options), UsageError);
    CHECK(default_budgets(100'000) == std::vector<int>{300, 1000, 3000});
    CHECK(default_budgets(10) == std::vector<int>{1, 1, 1});
}
