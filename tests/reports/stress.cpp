// SPDX-License-Identifier: Apache-2.0
// The hard cases hold, group by group so that groups run side by side, and a case can fail.
#include "reports/stress.h"

#include <catch2/catch.hpp>
#include <set>

using namespace plumbline;
using namespace plumbline::reports;

namespace {

void check_group(const std::string& group) {
    int count = 0;
    for (const HardCase& hard_case : hard_cases()) {
        if (hard_case.group != group) continue;
        const CaseResult result = run_case(hard_case);
        INFO(to_text(result));
        CHECK(result.passed());
        ++count;
    }
    CHECK(count > 0);
}

HardCase claiming(double measured) {
    return {"test", "a case", "what must hold",
            [=](Trial& trial) { trial.near("renderer", "value", measured, 2., .5); }};
}

}  // namespace

TEST_CASE("hard cases of scale hold", "[reports][stress]") { check_group("scale"); }
TEST_CASE("hard cases of light hold", "[reports][stress]") { check_group("light"); }
TEST_CASE("hard cases of geometry hold", "[reports][stress]") { check_group("geometry"); }
TEST_CASE("hard cases of energy hold", "[reports][stress]") { check_group("energy"); }
TEST_CASE("hard cases of probes hold", "[reports][stress]") { check_group("probes"); }
TEST_CASE("hard cases of motion hold", "[reports][stress]") { check_group("motion"); }
TEST_CASE("hard cases of statistics hold", "[reports][stress]") { check_group("statistics"); }

TEST_CASE("hard cases are many, named apart, and of the groups tested here", "[reports][stress]") {
    const std::set<std::string> tested{"scale",  "light",  "geometry",  "energy",
                                       "probes", "motion", "statistics"};
    std::set<std::string> names;
    for (const HardCase& hard_case : hard_cases()) {
        CHECK(tested.contains(hard_case.group));
        CHECK(!hard_case.law.empty());
        CHECK(names.insert(hard_case.group + ": " + hard_case.name).second);
    }
    CHECK(names.size() >= 40);
}

TEST_CASE("a case fails on a broken claim or a NaN or an error or when it claims nothing",
          "[reports][stress]") {
    CHECK(run_case(claiming(2.5)).passed());
    CHECK_FALSE(run_case(claiming(2.51)).passed());
    CHECK_FALSE(run_case(claiming(std::nan(""))).passed());
    CHECK_FALSE(
        run_case({"test", "thrower", "", [](Trial&) { throw std::runtime_error("no picture"); }})
            .passed());
    CHECK_FALSE(run_case({"test", "idler", "", [](Trial&) {}}).passed());
}

TEST_CASE("one broken claim among good ones is told in text and JSON and in the table",
          "[reports][stress]") {
    int shown = 0;
    const auto results = [&](const std::vector<HardCase>& cases) {
        return run_cases(cases, [&](const CaseResult&) { ++shown; });
    };
    CHECK(all_passed(results({claiming(2.), claiming(1.5)})));
    const std::vector<CaseResult> broken = results({claiming(2.), claiming(3.), claiming(2.)});
    CHECK_FALSE(all_passed(broken));
    CHECK(shown == 5);
    const StudySection section = stress_section(broken);
    CHECK(section.paragraphs[0].starts_with("2 of 3 hard cases hold"));
    REQUIRE(section.tables.size() == 1);
    CHECK(section.tables[0].rows[0][2] == "all 1 hold");
    CHECK(section.tables[0].rows[1][2] == "FAILED: renderer, value is 3.00, outside 1.50 to 2.50");
    const std::string text = to_text(run_case(claiming(3.)));
    CHECK(text.find("FAIL") == 0);
    CHECK(text.find("value is 3, outside [1.5, 2.5]") != std::string::npos);
    CHECK(to_json({run_case(claiming(3.))}).at("passed") == false);
}
