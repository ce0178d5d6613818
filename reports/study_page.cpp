// SPDX-License-Identifier: Apache-2.0
#include "reports/study_page.h"

#include <fmt/chrono.h>

#include <array>
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

}  // namespace

std::string study_html(const StudyPage& page) {
    const Machine machine = this_machine();
    json charts = json::array();
    json sections = json::array();
    for (const StudySection& section : page.sections)
        sections.push_back(section_context(section, "h2", charts));
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
         {"scripts", texts}},
        {"head.html", "section.html"});
}

}  // namespace plumbline::reports
