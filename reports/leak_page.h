// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "reports/leak.h"
#include "reports/study_page.h"

namespace plumbline::reports {

/// {"curves": [{"name", "options", "points": [{"cells", "lit", "dark", "share"}]}]}
nlohmann::ordered_json leak_json(const std::vector<LeakCurve>& curves);

/// Leak against thickness: a table in percent and a chart.
StudyPage leak_page(const std::vector<LeakCurve>& curves, const std::string& command);

}  // namespace plumbline::reports
