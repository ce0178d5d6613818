// SPDX-License-Identifier: Apache-2.0
#include "reports/leak.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "pathtracer/render.h"
#include "reports/leak_page.h"
#include "scenes/errors.h"
#include "tests/reports/page_parts.h"

using namespace plumbline;
using namespace plumbline::reports;

namespace {

AblationCase case_named(const std::string& name) {
    const std::vector<AblationCase> cases = leak_cases();
    return *std::ranges::find(cases, name, &AblationCase::name);
}

LeakOptions small(std::vector<double> cells) {
    LeakOptions options;
    options.cells = std::move(cells);
    options.width = 80;
    options.height = 45;
    return options;
}

}  // namespace

TEST_CASE("in truth no light passes the wall between the rooms, however thin", "[reports][leak]") {
    const double cells = GENERATE(0., .1, 1.);
    Scene rooms = rooms_with_wall(cells);
    rooms.camera.width = 80;
    rooms.camera.height = 45;
    pathtracer::RenderOptions render;
    render.spp = 16;
    const Leak leak = leak_in(pathtracer::render(rooms, 0, render).image, rooms, cells);
    CHECK(leak.lit > .05);
    CHECK(leak.dark == 0.);
}

TEST_CASE("the default leaks less than a hundredth through a wall a tenth of a cell thick",
          "[reports][leak]") {
    const auto curves =
        measure_leak({case_named("rays-visibility"), case_named("rays-none")}, small({0., .1, 1.}));
    for (const Leak& leak : curves[0].leaks) {
        CAPTURE(leak.cells);
        CHECK(leak.lit > .05);
        CHECK(leak.share() < .01);
    }
    CHECK(curves[1].leaks[1].share() > .02);  // what the weights keep out is there
    const std::string html = study_html(leak_page(curves, "plumbline leak"));
    CHECK(page_json(html)["charts"].size() == 1);
    CHECK(leak_json(curves)["curves"][1]["points"].size() == 3);
}

TEST_CASE("the default case of the leak is the default of the probes", "[reports][leak]") {
    CHECK(case_named("rays-visibility").options == "--model conserving");
    CHECK(case_named("octants-none").options ==
          "--model conserving --storage octants --weights none");
}

TEST_CASE("walls that cannot stand between two layers of probes are refused", "[reports][leak]") {
    const double cells = GENERATE(-.1, 1.5, std::nan(""));
    CHECK_THROWS_AS(measure_leak({}, small({cells})), UsageError);
    CHECK_THROWS_AS(measure_leak({}, small({})), UsageError);
}
