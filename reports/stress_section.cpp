// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <algorithm>

#include "reports/stress.h"
#include "reports/words.h"

namespace plumbline::reports {

namespace {

/// "all 12 hold", or the first claim that does not.
std::string outcome(const CaseResult& result) {
    if (!result.error.empty()) return "ended early: " + result.error;
    const auto broken = std::ranges::find_if_not(result.findings, &Finding::holds);
    if (broken == result.findings.end()) return fmt::format("all {} hold", result.findings.size());
    return fmt::format("FAILED: {}, {} is {}, outside {} to {}", broken->renderer, broken->claim,
                       number_text(broken->measured), number_text(broken->lowest),
                       number_text(broken->highest));
}

}  // namespace

StudySection stress_section(const std::vector<CaseResult>& results) {
    const auto passed = std::ranges::count_if(results, &CaseResult::passed);
    std::size_t claims = 0;
    for (const CaseResult& result : results) claims += result.findings.size();
    StudySection section{
        "Hard cases",
        {fmt::format("{} of {} hard cases hold, {} claims in all, for the path tracer and every "
                     "probe model: plumbline stress.",
                     passed, results.size(), claims)},
        {},
        {},
        {}};
    for (const CaseResult& result : results) {
        if (section.tables.empty() || section.tables.back().caption != result.group)
            section.tables.push_back({result.group, {"Case", "the law", "claims", "time"}, {}});
        section.tables.back().rows.push_back(
            {result.name, result.law, outcome(result), duration_text(result.seconds)});
    }
    return section;
}

}  // namespace plumbline::reports
