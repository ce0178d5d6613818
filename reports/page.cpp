// SPDX-License-Identifier: Apache-2.0
#include "reports/page.h"

#include <kainjow/mustache.hpp>
#include <stdexcept>

#include "reports/page_context.h"
#include "reports/page_data.h"
#include "reports/page_files.h"

namespace plumbline::reports {

namespace {

using kainjow::mustache::data;
using kainjow::mustache::mustache;

/// Pictures shrink to no less than one over this.
constexpr int smallest_fraction = 16;

/// What a template can show: numbers must have become text before.
data template_data(const nlohmann::json& json) {
    switch (json.type()) {
        case nlohmann::json::value_t::object: {
            data object{data::type::object};
            for (const auto& [key, value] : json.items()) object.set(key, template_data(value));
            return object;
        }
        case nlohmann::json::value_t::array: {
            data list{data::type::list};
            for (const nlohmann::json& value : json) list.push_back(template_data(value));
            return list;
        }
        case nlohmann::json::value_t::boolean:
            return data{json.get<bool>()};
        case nlohmann::json::value_t::string:
            return data{json.get<std::string>()};
        case nlohmann::json::value_t::null:
            return data{false};
        default:
            return data{json.dump()};
    }
}

data partial(const std::string& name) {
    return data{kainjow::mustache::partial{[name] { return std::string(page_file(name)); }}};
}

std::string page_at(const Report& report, int block) {
    const PageData shown = page_data(report, block);
    data context = template_data(page_context(report, block));
    context.set("data", script_json(shown.json));
    context.set("layers", shown.layer_elements);
    context.set("verdict", partial("verdict.html"));
    context.set("scene", partial("scene.html"));
    mustache page{std::string(page_file("index.html"))};
    std::string html = page.render(context);
    if (!page.is_valid()) throw std::runtime_error("the page's template: " + page.error_message());
    return html;
}

}  // namespace

std::string page_html(const Report& report, std::size_t largest) {
    std::string html = page_at(report, 1);
    for (int block = 2; html.size() > largest && block <= smallest_fraction; block *= 2)
        html = page_at(report, block);
    return html;
}

}  // namespace plumbline::reports
