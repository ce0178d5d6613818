// SPDX-License-Identifier: Apache-2.0
#include "reports/results_markdown.h"

#include <catch2/catch.hpp>

#include "reports/words.h"
#include "tests/reports/page_parts.h"
#include "tests/reports/synthetic_report.h"

using namespace plumbline;
using namespace plumbline::reports;

namespace {

Report published_report() {
    Report report = synthetic_report(32, 18);
    report.shared = report.scenes[0].fit->result;
    report.transfer =
        Transfer{32, 18, 64, {{"one", 0, "one", 0, .1}, {"one", 0, "other", 350, .123}}};
    return report;
}

}  // namespace

TEST_CASE("the published results hold each model with its error and command",
          "[reports][publish]") {
    const Report report = published_report();
    const std::string text = results_markdown(report);
    CHECK(text.find(report.command) != std::string::npos);
    for (const ModelRun& run : report.scenes[0].models) {
        CAPTURE(run.title);
        CHECK(text.find("`" + run.command + "`") != std::string::npos);
        CHECK(text.find(number_text(run.errors.indirect.comparison.metrics.rmse)) !=
              std::string::npos);
    }
    CHECK(text.find("| one, frame 0 | 0.100 (1.00 \u00d7) | 0.123 |") != std::string::npos);
    CHECK(text.find("no, only together with others") != std::string::npos);
    CHECK(text.find("](results-synthetic-0.png)") != std::string::npos);
}

TEST_CASE("a scene's name cannot break the published table or leave the folder",
          "[reports][publish]") {
    Report report = synthetic_report(32, 18);
    report.scenes[0].name = "../a|b`\n<script>";
    const FolderFiles files = published_files(report, "RESULTS.md");
    REQUIRE(files.size() == 2);
    CHECK(files[0].first == "RESULTS.md");
    CHECK(files[1].first == "results----a-b---script-.png");
    CHECK(files[1].second.substr(1, 3) == "PNG");
    CHECK(count(files[0].second, "<script>") == count(files[0].second, "\\<script>"));
}
