// SPDX-License-Identifier: Apache-2.0
#include "reports/stress.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

namespace plumbline::reports {

bool CaseResult::passed() const {
    return error.empty() && !findings.empty() && std::ranges::all_of(findings, &Finding::holds);
}

CaseResult run_case(const HardCase& hard_case) {
    const auto begin = std::chrono::steady_clock::now();
    Trial trial;
    std::string error;
    try {
        hard_case.run(trial);
    } catch (const std::exception& thrown) {
        error = thrown.what();
    }
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    return {hard_case.group, hard_case.name, hard_case.law, trial.findings(), error, taken.count()};
}

std::string to_text(const CaseResult& result) {
    std::string text = fmt::format("{} {:<11} {:<48} {:3} claims {:6.2f} s  {}\n",
                                   result.passed() ? "ok  " : "FAIL", result.group, result.name,
                                   result.findings.size(), result.seconds, result.law);
    for (const Finding& finding : result.findings) {
        if (finding.holds()) continue;
        text += fmt::format("     {}: {} is {:.9g}, outside [{:.9g}, {:.9g}]\n", finding.renderer,
                            finding.claim, finding.measured, finding.lowest, finding.highest);
    }
    if (!result.error.empty()) text += fmt::format("     ended early: {}\n", result.error);
    return text;
}

nlohmann::ordered_json to_json(const std::vector<CaseResult>& results) {
    nlohmann::ordered_json json;
    json["passed"] = std::ranges::all_of(results, &CaseResult::passed);
    json["cases"] = nlohmann::ordered_json::array();
    for (const CaseResult& result : results) {
        nlohmann::ordered_json findings = nlohmann::ordered_json::array();
        for (const Finding& finding : result.findings) {
            findings.push_back({{"renderer", finding.renderer},
                                {"claim", finding.claim},
                                {"measured", finding.measured},
                                {"lowest", finding.lowest},
                                {"highest", finding.highest},
                                {"holds", finding.holds()}});
        }
        json["cases"].push_back({{"group", result.group},
                                 {"name", result.name},
                                 {"law", result.law},
                                 {"passed", result.passed()},
                                 {"seconds", result.seconds},
                                 {"findings", findings},
                                 {"error", result.error}});
    }
    return json;
}

int stress(const std::vector<HardCase>& cases, bool json) {
    std::vector<CaseResult> results;
    for (const HardCase& hard_case : cases) {
        results.push_back(run_case(hard_case));
        std::FILE* const terminal = json ? stderr : stdout;
        fmt::print(terminal, "{}", to_text(results.back()));
        std::fflush(terminal);  // into a pipe too, line by line
    }
    if (json) fmt::print("{}\n", to_json(results).dump(2));
    return std::ranges::all_of(results, &CaseResult::passed) ? 0 : 1;
}

}  // namespace plumbline::reports
