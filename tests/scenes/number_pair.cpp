// SPDX-License-Identifier: Apache-2.0
#include "scenes/number_pair.h"

#include <catch2/catch.hpp>

using namespace plumbline;

TEST_CASE("two whole numbers from 1 on are read and nothing else", "[scenes]") {
    CHECK(parsed_pair("480x270", 'x') == glm::ivec2(480, 270));
    CHECK(parsed_pair("1/4", '/') == glm::ivec2(1, 4));
    for (const char* text :
         {"", "x", "1x", "x1", "0x1", "1x0", "-1x3", "1x-3", "+1x3", " 1x3", "1x3 ", "1x3x5", "1/3",
          "1.5x3", "99999999999x1", "1x2147483648", "nanx1"}) {
        CAPTURE(text);
        CHECK_FALSE(parsed_pair(text, 'x'));
    }
}
