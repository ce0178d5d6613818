// SPDX-License-Identifier: Apache-2.0
#include "reports/page.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <regex>

#include "tests/reports/page_parts.h"
#include "tests/reports/synthetic_report.h"

using namespace plumbline;
using namespace plumbline::reports;

TEST_CASE("the page refers to nothing outside itself", "[reports][page]") {
    const std::string markup = without_scripts(page_html(synthetic_report(32, 18)));
    const std::regex reference("(?:src|href|action|data|poster)\\s*=\\s*\"([^\"]*)\"");
    std::size_t references = 0;
    for (std::sregex_iterator it(markup.begin(), markup.end(), reference), end; it != end; ++it) {
        const std::string target = (*it)[1];
        CAPTURE(target.substr(0, 80));
        CHECK((target.starts_with("data:image/png;base64,") || target.starts_with("#")));
        ++references;
    }
    CHECK(references > 10);
    CHECK(markup.find("http:") == std::string::npos);
    CHECK(markup.find("https:") == std::string::npos);
    CHECK(markup.find("url(") == std::string::npos);
    CHECK(markup.find("@import") == std::string::npos);
    CHECK(markup.find("default-src 'none'") != std::string::npos);
}

TEST_CASE("every template key of the page has a value", "[reports][page]") {
    const std::string html = page_html(synthetic_report(32, 18, 2));
    CHECK(html.find("{{") == std::string::npos);
    // A key that the context lacks leaves nothing behind.
    const std::string markup = without_scripts(html);
    const std::regex empty("<(h1|h2|h3|h4|td|th|li|code|figcaption)[^>]*>\\s*</\\1>");
    std::smatch match;
    const bool found = std::regex_search(markup, match, empty);
    CAPTURE(found ? std::string(match.prefix()).substr(match.prefix().length() - 80) : "");
    CHECK(!found);
}

TEST_CASE("text from a scene cannot become markup or script", "[reports][page]") {
    const std::string benign = page_html(synthetic_report(32, 18));
    const std::string hostile = page_html(synthetic_report(32, 18, 1, true));
    for (const char* tag : {"<script", "</script", "<img", "<!--"}) {
        CAPTURE(tag);
        CHECK(count(hostile, tag) == count(benign, tag));
    }
    CHECK(hostile.find("&lt;img src=x onerror=alert(2)&gt;") != std::string::npos);
    CHECK(page_json(hostile)["scenes"][0]["name"] == hostile_text);
}

TEST_CASE("a page that would be too large shows smaller pictures and says so", "[reports][page]") {
    const Report report = synthetic_report(64, 36);
    const std::string whole = page_html(report);
    CHECK(whole.find("means of") == std::string::npos);
    const std::string small = page_html(report, whole.size() - 1);
    CHECK(small.size() < whole.size());
    CHECK(small.find("means of 2 x 2 pixels") != std::string::npos);
    const nlohmann::json scene = page_json(small)["scenes"][0];
    CHECK(scene["width"] == 32);
    CHECK(scene["height"] == 18);
}

TEST_CASE("the page shows each model's accuracy and time in one row of the verdict",
          "[reports][page]") {
    const std::string html = page_html(synthetic_report(32, 18));
    const std::size_t best = html.find("<tr class=\"best\">");
    REQUIRE(best != std::string::npos);
    const std::string row = html.substr(best, html.find("</tr>", best) - best);
    CHECK(row.find("conserving") != std::string::npos);
    CHECK(row.find("97 %") != std::string::npos);
    CHECK(row.find("306 ms") != std::string::npos);
    CHECK(row.find("3.40 s") != std::string::npos);
}
