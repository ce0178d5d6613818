// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "reports/ablation.h"
#include "reports/study_page.h"

namespace plumbline::reports {

/// {"scenes": [{"scene", "frame", "width", "height", "cases": [...]}]}
nlohmann::ordered_json ablation_json(const std::vector<AblationScene>& scenes);

/// One line a scene and case.
std::string ablation_csv(const std::vector<AblationScene>& scenes);

/// A table of each group of cases, and error against the time of an update.
StudyPage ablation_page(const std::vector<AblationScene>& scenes, const std::string& command);

}  // namespace plumbline::reports
