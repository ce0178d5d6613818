// SPDX-License-Identifier: Apache-2.0
#include "reports/study_section.h"

#include <cmath>

namespace plumbline::reports {

namespace {

using nlohmann::json;

json numbers(const std::vector<double>& values) {
    json list = json::array();
    for (const double value : values) list.push_back(std::isfinite(value) ? json(value) : json());
    return list;
}

json chart_json(const StudyChart& chart) {
    json series = json::array();
    for (const StudySeries& one : chart.series)
        series.push_back({{"label", one.label},
                          {"color", one.color},
                          {"x", numbers(one.x)},
                          {"y", numbers(one.y)},
                          {"dashed", one.dashed},
                          {"dots", one.dots},
                          {"line", one.line},
                          {"names", one.names}});
    return {{"x_title", chart.x_title}, {"y_title", chart.y_title}, {"series", series},
            {"labels", chart.labels},   {"marks", chart.marks},     {"log_x", chart.log_x},
            {"log_y", chart.log_y}};
}

json table_context(const StudyTable& table) {
    json rows = json::array();
    for (const std::vector<std::string>& row : table.rows) {
        rows.push_back({{"name", row.front()}, {"cells", std::vector(row.begin() + 1, row.end())}});
    }
    return {{"caption", table.caption}, {"head", table.head}, {"rows", rows}};
}

}  // namespace

json section_context(const StudySection& section, const std::string& level, json& charts) {
    json tables = json::array();
    for (const StudyTable& table : section.tables) tables.push_back(table_context(table));
    json canvases = json::array();
    for (const StudyChart& chart : section.charts) {
        canvases.push_back({{"number", std::to_string(charts.size())}, {"caption", chart.caption}});
        charts.push_back(chart_json(chart));
    }
    json pictures = json::array();
    for (const StudyPicture& picture : section.pictures)
        pictures.push_back({{"uri", picture.uri}, {"caption", picture.caption}});
    return {{"heading", section.heading},
            {"level", level},
            {"paragraphs", section.paragraphs},
            {"tables", tables},
            {"charts", canvases},
            {"has_pictures", !section.pictures.empty()},
            {"pictures", pictures}};
}

}  // namespace plumbline::reports
