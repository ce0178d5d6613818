// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "reports/animation.h"
#include "scenes/scene.h"

namespace plumbline::reports {

/// What a frame took and counted, and how far its picture is from that without a budget.
struct BudgetFrame {
    double update_ms;  ///< placing and lighting surfels and updating the probes
    std::uint64_t replaced;
    std::uint64_t shadow_rays;  ///< of surfels
    std::uint64_t waiting;      ///< surfels
    int oldest_wait;            ///< in frames
    double lag;  ///< RMSE of the indirect layer against the same frame without a budget
};

/// An animation played with one budget.
struct BudgetRun {
    std::optional<int> budget;        ///< surfels a frame; none: all that something touched
    std::vector<BudgetFrame> frames;  ///< one a frame of BudgetStudy::frames
    std::vector<MovingError> errors;  ///< one a frame of BudgetStudy::held
};

/// What it costs, in error and time, to spread the work of an animation over frames.
struct BudgetStudy {
    std::string model;
    int first, last;  ///< keys between which something moves
    int width, height, truth_spp;
    std::uint64_t surfels;
    std::vector<int> frames;      ///< that were played, past `last` for a while
    std::vector<int> held;        ///< those of them that were held against a truth of their own
    std::vector<BudgetRun> runs;  ///< the first without a budget
};

struct BudgetOptions {
    std::string model = "conserving";
    std::vector<int> budgets;  ///< empty: shares of all surfels, see default_budgets()
    int truth_spp = 128;
    int truths = 16;  ///< frames that are held against one, spread over all
};

/// 0.3, 1 and 3 % of a scene's surfels.
std::vector<int> default_budgets(std::uint64_t surfels);

/// Plays a scene's motion, from probes settled before it, a frame at a time and once for each
/// budget, and a third as many frames at rest. Throws UsageError, also if nothing moves.
BudgetStudy measure_budget(const Scene& scene, const BudgetOptions& options);

}  // namespace plumbline::reports
