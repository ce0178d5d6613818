// SPDX-License-Identifier: Apache-2.0
#include "reports/template.h"

#include <filesystem>
#include <kainjow/mustache.hpp>
#include <stdexcept>

#include "reports/page_files.h"

namespace plumbline::reports {

namespace {

using kainjow::mustache::data;
using kainjow::mustache::mustache;

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

}  // namespace

std::string fill_template(const std::string& name, const nlohmann::json& context,
                          const std::vector<std::string>& partials) {
    data values = template_data(context);
    for (const std::string& file : partials)
        values.set(std::filesystem::path(file).stem().string(), partial(file));
    mustache page{std::string(page_file(name))};
    std::string html = page.render(values);
    if (!page.is_valid())
        throw std::runtime_error("the template " + name + ": " + page.error_message());
    return html;
}

}  // namespace plumbline::reports
