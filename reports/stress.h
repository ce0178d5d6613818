// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "reports/hard_case.h"
#include "reports/study_section.h"

namespace plumbline::reports {

/// What came of a hard case.
struct CaseResult {
    std::string group;
    std::string name;
    std::string law;
    std::vector<Finding> findings;
    std::string error;  ///< what ended it early, if anything did
    double seconds;

    bool passed() const;
};

/// Runs one case; an error that it throws fails it.
CaseResult run_case(const HardCase& hard_case);

/// One line for the terminal, and below it a line for each claim that does not hold.
std::string to_text(const CaseResult& result);

/// Runs the cases one by one and shows each result when it is there.
std::vector<CaseResult> run_cases(const std::vector<HardCase>& cases,
                                  const std::function<void(const CaseResult&)>& show);

bool all_passed(const std::vector<CaseResult>& results);

/// A table for each group: case, law, how many claims hold, time, and what does not hold.
StudySection stress_section(const std::vector<CaseResult>& results);

/// {"passed", "cases": [{"group", "name", "law", "passed", "seconds", "findings": [{"renderer",
/// "claim", "measured", "lowest", "highest", "holds"}], "error"}]}; not-finite numbers are null.
nlohmann::ordered_json to_json(const std::vector<CaseResult>& results);

}  // namespace plumbline::reports
