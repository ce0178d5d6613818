// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "reports/report.h"

namespace plumbline::reports {

/// What the page's scripts work on: {color_maps, scenes: [{name, width, height, exposure, best,
/// layers, pictures, noise, error_range, frontier, split}]}, and the HTML elements that hold the
/// packed layers that it names. Layers are shown at 1/`block` of their size.
struct PageData {
    nlohmann::json json;
    std::string layer_elements;
};

PageData page_data(const Report& report, int block);

/// JSON that may stand inside an HTML script element, whatever its strings hold.
std::string script_json(const nlohmann::json& json);

}  // namespace plumbline::reports
