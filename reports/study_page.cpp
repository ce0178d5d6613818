// SPDX-License-Identifier: Apache-2.0
#include "reports/study_page.h"

#include <fmt/chrono.h>

#include <array>
#include <cmath>
#include <ctime>

#include "reports/machine.h"
#include "reports/page_data.h"
#include "reports/page_files.h"
#include "reports/template.h"

namespace plumbline::reports {

namespace {

using nlohmann::json;

/// In the order in which they build on each other.
constexpr std::array scripts{"chart.min.js", "theme.js", "tables.js", "study.js"};

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

/// What the template shows of a section; its charts are appended to `charts` and named by number.
json section_context(const StudySection& section, json& charts) {
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
            {"paragraphs", section.paragraphs},
            {"tables", tables},
            {"charts", canvases},
            {"has_pictures", !section.pictures.empty()},
            {"pictures", pictures}};
}

}  // namespace

std::string study_html(const StudyPage& page) {
    const Machine machine = this_machine();
    json charts = json::array();
    json sections = json::array();
    for (const StudySection& section : page.sections)
        sections.push_back(section_context(section, charts));
    json texts = json::array();
    for (const char* name : scripts) texts.push_back({{"text", page_file(name)}});
    return fill_template(
        "study.html",
        {{"version", PLUMBLINE_VERSION},
         {"title", page.title},
         {"date", fmt::format("{:%Y-%m-%d %H:%M} UTC", fmt::gmtime(std::time(nullptr)))},
         {"cpu", machine.cpu},
         {"system", machine.system},
         {"threads", machine.threads},
         {"style", page_style()},
         {"lead", page.lead},
         {"sections", sections},
         {"command", page.command},
         {"data", script_json({{"charts", charts}})},
         {"scripts", texts}});
}

}  // namespace plumbline::reports
