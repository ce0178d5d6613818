// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/frontier.h"
#include "reports/machine.h"
#include "reports/scene_report.h"

namespace plumbline::reports {

/// All that a page and a results.json are made of.
struct Report {
    std::string version;
    std::string date;     ///< ISO 8601, UTC
    std::string command;  ///< that made the report
    std::string quality;
    Machine machine;
    std::vector<SceneReport> scenes;
    std::vector<Frontier> frontiers{};             ///< of each scene, if they were measured
    std::optional<compare::FitResult> transfer{};  ///< one fit to all scenes, if it was asked for
};

}  // namespace plumbline::reports
