// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "reports/budget.h"
#include "reports/study_page.h"

namespace plumbline::reports {

/// {"model", "width", "height", "truth_spp", "surfels", "first", "last", "budgets": [{"budget"
/// (null: none), "update_ms_moving", "replaced_moving", "shadow_rays_moving", "most_replaced",
/// "most_waiting", "longest_wait", "rmse_moving", "mean_ratio_moving", "lag_moving", "most_lag",
/// "frames_to_settle"}]}; means over the frames that move, "rmse" without the truth's noise.
nlohmann::ordered_json budget_json(const BudgetStudy& study);

/// A line a budget and frame; error and mean ratio are empty where no truth was made.
std::string budget_csv(const BudgetStudy& study);

/// Error, lag, work and waiting surfels over the frames.
StudyPage budget_page(const BudgetStudy& study, const std::string& scene,
                      const std::string& command);

}  // namespace plumbline::reports
