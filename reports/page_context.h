// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "reports/report.h"

namespace plumbline::reports {

/// What reports/page/index.html and its parts show, as text; pictures at 1/`block` of their size.
/// Appends to `charts` what study.js draws.
nlohmann::json page_context(const Report& report, int block, nlohmann::json& charts);

}  // namespace plumbline::reports
