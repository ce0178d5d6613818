// SPDX-License-Identifier: Apache-2.0
#include "ddgi/grid.h"

#include <catch2/catch.hpp>
#include <numeric>

#include "scenes/errors.h"

using namespace plumbline;
using namespace plumbline::ddgi;

namespace {

const ProbeGrid grid{{-200.f, 0.f, -200.f}, 20.f, {21, 12, 21}};

}  // namespace

TEST_CASE("probes lie layer by layer in y, lines of constant x, z contiguous", "[ddgi]") {
    CHECK(probe_count(grid) == 5292);
    CHECK(probe_index(grid, {0, 0, 0}) == 0);
    CHECK(probe_index(grid, {0, 0, 1}) == 1);
    CHECK(probe_index(grid, {1, 0, 0}) == 21);
    CHECK(probe_index(grid, {0, 1, 0}) == 21 * 21);
    CHECK(probe_position(grid, 21 * 21 + 2 * 21 + 3) == glm::vec3(-160.f, 20.f, -140.f));
    for (std::uint32_t probe = 0; probe < probe_count(grid); ++probe) {
        REQUIRE(probe_index(grid, probe_cell(grid, probe)) == probe);
    }
}

TEST_CASE("trilinear weights sum to one and reproduce a linear field", "[ddgi]") {
    const auto field = [](const glm::vec3& p) { return 3.f + p.x - 2.f * p.y + 0.5f * p.z; };
    for (const glm::vec3 x : {glm::vec3(-13.f, 27.f, 111.f), glm::vec3(200.f, 220.f, 200.f),
                              glm::vec3(-200.f, 0.f, -200.f), glm::vec3(0.f, 100.f, 20.f)}) {
        const ProbeNeighbours around = probe_neighbours(grid, x);
        CHECK(std::accumulate(around.weight.begin(), around.weight.end(), 0.f) == Approx(1.f));
        float blended = 0.f;
        for (std::size_t i = 0; i < 8; ++i) {
            REQUIRE(around.probe[i] < probe_count(grid));
            blended += around.weight[i] * field(probe_position(grid, around.probe[i]));
        }
        CHECK(blended == Approx(field(x)));
    }
}

TEST_CASE("a point outside the grid is looked up at the nearest point of its border", "[ddgi]") {
    const ProbeNeighbours outside = probe_neighbours(grid, {-300.f, 500.f, 7.f});
    const ProbeNeighbours border = probe_neighbours(grid, {-200.f, 220.f, 7.f});
    CHECK(outside.probe == border.probe);
    CHECK(outside.weight == border.weight);
}

TEST_CASE("another spacing keeps the extent, or reaches over it by less than a cell", "[ddgi]") {
    CHECK(with_spacing(grid, 40.f).counts == glm::ivec3(11, 7, 11));
    CHECK(with_spacing(grid, 10.f).counts == glm::ivec3(41, 23, 41));
    CHECK(with_spacing(grid, 10.f).origin == grid.origin);
    const ProbeGrid odd = with_spacing(grid, 13.3f);
    const glm::vec3 overhang = odd.spacing * glm::vec3(odd.counts - 1) - glm::vec3(400, 220, 400);
    CHECK(min_component(overhang) >= 0.f);
    CHECK(max_component(overhang) < 13.3f);
    CHECK(odd.origin.x == Approx(-200.f - overhang.x / 2.f));
    CHECK_THROWS_AS(with_spacing(grid, 0.f), UsageError);
    CHECK_THROWS_AS(with_spacing(grid, -1.f), UsageError);
    CHECK_THROWS_AS(with_spacing(grid, std::nanf("")), UsageError);
    CHECK_THROWS_AS(with_spacing(grid, 1e-3f), UsageError);
}
