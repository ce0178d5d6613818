// SPDX-License-Identifier: Apache-2.0
#include "reports/page.h"

#include "reports/page_context.h"
#include "reports/page_data.h"
#include "reports/template.h"

namespace plumbline::reports {

namespace {

/// Pictures shrink to no less than one over this.
constexpr int smallest_fraction = 16;

std::string page_at(const Report& report, int block) {
    PageData shown = page_data(report, block);
    nlohmann::json charts = nlohmann::json::array();
    nlohmann::json context = page_context(report, block, charts);
    shown.json["charts"] = charts;
    context["data"] = script_json(shown.json);
    context["layers"] = std::move(shown.layer_elements);
    return fill_template("index.html", context,
                         {"head.html", "section.html", "verdict.html", "scene.html"});
}

}  // namespace

std::string page_html(const Report& report, std::size_t largest) {
    std::string html = page_at(report, 1);
    for (int block = 2; html.size() > largest && block <= smallest_fraction; block *= 2)
        html = page_at(report, block);
    return html;
}

}  // namespace plumbline::reports
