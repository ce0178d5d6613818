// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/machine.h"
#include "reports/scene_report.h"
#include "reports/stress.h"
#include "reports/transfer.h"

namespace plumbline::reports {

/// All that a page and a results.json are made of.
struct Report {
    std::string version;
    std::string date;     ///< ISO 8601, UTC
    std::string command;  ///< that made the report
    std::string quality;
    Machine machine;
    std::vector<SceneReport> scenes;
    std::optional<Transfer> transfer{};  ///< none without a scene that has the thesis's constants
    std::optional<compare::FitResult> shared{};  ///< one fit to all such scenes, if several
    std::vector<CaseResult> hard_cases{};        ///< if they were asked for
};

}  // namespace plumbline::reports
