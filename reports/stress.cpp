// SPDX-License-Identifier: Apache-2.0
#include "reports/stress.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

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
    json["passed"] = all_passed(results);
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

std::vector<CaseResult> run_cases(const std::vector<HardCase>& cases,
                                  const std::function<void(const CaseResult&)>& show) {
    std::vector<CaseResult> results;
    for (const HardCase& hard_case : cases) {
        results.push_back(run_case(hard_case));
        show(results.back());
    }
    return results;
}

bool all_passed(const std::vector<CaseResult>& results) {
    return std::ranges::all_of(results, &CaseResult::passed);
}

}  // namespace plumbline::reports
