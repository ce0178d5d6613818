// SPDX-License-Identifier: Apache-2.0
#include "reports/words.h"

#include <catch2/catch.hpp>
#include <cmath>

using namespace plumbline::reports;

TEST_CASE("numbers keep three significant digits, whatever they round to", "[reports][words]") {
    CHECK(number_text(0.04712) == "0.0471");
    CHECK(number_text(0.0099996) == "0.0100");
    CHECK(number_text(12.44) == "12.4");
    CHECK(number_text(-306.2) == "-306");
    CHECK(number_text(0) == "0");
    CHECK(number_text(1.234e-5) == "1.23e-05");
    CHECK(number_text(HUGE_VAL) == "inf");
}

TEST_CASE("times have the unit that reads best", "[reports][words]") {
    CHECK(duration_text(0.0004) == "400 \u00b5s");
    CHECK(duration_text(0.0124) == "12.4 ms");
    CHECK(duration_text(3.21) == "3.21 s");
    CHECK(duration_text(125.2) == "2 min 5 s");
    CHECK(duration_text(7325) == "2 h 2 min");
}

TEST_CASE("a mean ratio is told as per cent when near and as times when far", "[reports][words]") {
    CHECK(ratio_words(1.006) == "0.60 % too bright");
    CHECK(ratio_words(0.97) == "3.0 % too dark");
    CHECK(ratio_words(0.08) == "12.5 times too dark");
    CHECK(ratio_words(2) == "2.00 times too bright");
}

TEST_CASE("shares near the whole keep the digits that tell them from it", "[reports][words]") {
    CHECK(percent_text(0.9987) == "99.87 %");
    CHECK(percent_text(1) == "100 %");
    CHECK(percent_text(0.58) == "58 %");
    CHECK(percent_text(0.0008) == "0.08 %");
}

TEST_CASE("any text is one word of a shell's command line", "[reports][words]") {
    CHECK(shell_word("scenes/a-b_c.json") == "scenes/a-b_c.json");
    CHECK(shell_word("my scene.json") == "'my scene.json'");
    CHECK(shell_word("it's") == "'it'\\''s'");
    CHECK(shell_word("$(reboot)") == "'$(reboot)'");
}
