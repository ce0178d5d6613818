// SPDX-License-Identifier: Apache-2.0
#include "reports/leak_page.h"

#include <fmt/core.h>

namespace plumbline::reports {

namespace {

using nlohmann::ordered_json;

/// Colours that style.css has for lines; curves beyond are dashed.
constexpr std::size_t colors = 6;

StudyTable leak_table(const std::vector<LeakCurve>& curves) {
    StudyTable table{
        "Dark room's mean indirect radiance over the lit room's, percent", {"Wall, cells"}, {}};
    for (const Leak& leak : curves.front().leaks)
        table.head.push_back(fmt::format("{}", leak.cells));
    for (const LeakCurve& curve : curves) {
        std::vector<std::string> row{curve.subject.title};
        for (const Leak& leak : curve.leaks)
            row.push_back(fmt::format("{:.3g}", 100. * leak.share()));
        table.rows.push_back(row);
    }
    return table;
}

StudyChart leak_chart(const std::vector<LeakCurve>& curves) {
    StudyChart chart;
    chart.caption = "Leak against the thickness of the wall";
    chart.x_title = "thickness, cells";
    chart.y_title = "percent of the lit room";
    for (std::size_t i = 0; i < curves.size(); ++i) {
        StudySeries series{curves[i].subject.title,
                           fmt::format("series-{}", i % colors),
                           {},
                           {},
                           i >= colors,
                           true};
        for (const Leak& leak : curves[i].leaks) {
            series.x.push_back(leak.cells);
            series.y.push_back(100. * leak.share());
        }
        chart.series.push_back(series);
    }
    return chart;
}

}  // namespace

ordered_json leak_json(const std::vector<LeakCurve>& curves) {
    ordered_json list = ordered_json::array();
    for (const LeakCurve& curve : curves) {
        ordered_json points = ordered_json::array();
        for (const Leak& leak : curve.leaks)
            points.push_back({{"cells", leak.cells},
                              {"lit", leak.lit},
                              {"dark", leak.dark},
                              {"share", leak.share()}});
        list.push_back(
            {{"name", curve.subject.name}, {"options", curve.subject.options}, {"points", points}});
    }
    return {{"curves", list}};
}

StudyPage leak_page(const std::vector<LeakCurve>& curves, const std::string& command) {
    return {
        "Light through a wall",
        command,
        {"The scene two-rooms with its door shut: no light can reach the dark room, so all that "
         "the probes show there leaked. The wall stands between two layers of probes; its "
         "thickness is in spacings of theirs."},
        {{"Leak", {}, {leak_table(curves)}, {leak_chart(curves)}, {}}}};
}

}  // namespace plumbline::reports
