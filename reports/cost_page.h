// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "reports/cost.h"
#include "reports/study_page.h"

namespace plumbline::reports {

/// cost.json: the points of both sweeps, and their exponents with intervals.
nlohmann::ordered_json cost_json(const CostStudy& study, const std::string& scene);

/// The same as tables and charts.
StudyPage cost_page(const CostStudy& study, const std::string& scene, const std::string& command);

}  // namespace plumbline::reports
