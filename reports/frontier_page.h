// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "reports/frontier.h"
#include "reports/study_page.h"

namespace plumbline::reports {

/// The chart and the Pareto frontier of each budget, and every picture's figures.
std::vector<StudySection> frontier_sections(const Frontier& frontier);

/// All that was measured and found; undefined values are null.
nlohmann::ordered_json frontier_json(const Frontier& frontier);

/// A line for each picture; what is undefined is empty.
std::string frontier_csv(const Frontier& frontier);

/// `command` makes the same page.
StudyPage frontier_page(const Frontier& frontier, const std::string& command);

}  // namespace plumbline::reports
