// SPDX-License-Identifier: Apache-2.0
#include "scenes/kept_lanes.h"

#include <catch2/catch.hpp>
#include <random>
#include <vector>

namespace plumbline {
namespace {

/// What a loop over single lanes keeps.
std::vector<float> kept_one_by_one(std::size_t count, const Lanes<std::int32_t>& flags,
                                   const Lanes<float>& from) {
    std::vector<float> kept;
    for (std::size_t i = 0; i < count; ++i) {
        if (flags[i] != 0) kept.push_back(from[i]);
    }
    return kept;
}

}  // namespace

TEST_CASE("kept lanes stand side by side in their order", "[scenes][lanes]") {
    std::mt19937 random(3);
    const double share = GENERATE(0., .1, .5, .9, 1.);
    for (std::size_t count = 0; count <= lane_count; ++count) {
        Lanes<std::int32_t> flags;
        Lanes<float> from;
        for (std::size_t i = 0; i < lane_count; ++i) {
            // Flags behind the last lane must not count; any value but 0 is a flag.
            flags[i] = std::bernoulli_distribution(share)(random) ? (i % 2 == 0 ? 1 : -256) : 0;
            from[i] = static_cast<float>(i);
        }
        const std::vector<float> expected = kept_one_by_one(count, flags, from);
        const KeptLanes kept(count, flags);
        REQUIRE(kept.count() == expected.size());
        Lanes<float> to;
        kept.close_up(from, to);
        kept.close_up(from);
        REQUIRE(std::equal(expected.begin(), expected.end(), to.begin()));
        REQUIRE(std::equal(expected.begin(), expected.end(), from.begin()));
    }
}

}  // namespace plumbline
