// SPDX-License-Identifier: Apache-2.0
#include "ddgi/patterns.h"

#include <array>
#include <catch2/catch.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtx/norm.hpp>
#include <set>

#include "scenes/errors.h"

using namespace plumbline;
using namespace plumbline::ddgi;

namespace {

/// Azimuth of `direction` relative to that of principal direction d, in degrees, in (-180, 180].
float relative_azimuth(const glm::vec3& direction, std::size_t d) {
    const glm::ivec3& D = principal_directions[d];
    const float cosine = direction.x * float(D.x) + direction.z * float(D.z);
    const float sine = direction.z * float(D.x) - direction.x * float(D.z);
    return glm::degrees(std::atan2(sine, cosine));
}

float polar_angle(const glm::vec3& direction) { return glm::degrees(std::acos(direction.y)); }

}  // namespace

TEST_CASE("the thesis's rays have the published angles", "[ddgi]") {
    const int surfels = GENERATE(64, 96, 128, 160);
    const RayPattern pattern = thesis_pattern(surfels);
    REQUIRE(pattern.size() == surfels);
    const int azimuths = surfels / 8;
    std::multiset<std::pair<int, int>> published;  // rounded to 1/100 degree
    std::multiset<std::pair<int, int>> found;
    const auto rounded = [](double degrees) { return int(std::lround(100. * degrees)); };
    const auto azimuth_in_turn = [](double degrees) {
        return std::fmod(degrees + 720.001, 360.) - 0.001;
    };
    for (int j = 0; j < 8; ++j) {
        for (int i = 0; i < azimuths; ++i) {
            const double theta = 360. * i / azimuths - (360. / azimuths) * (surfels - 32) / 64.;
            published.emplace(rounded(22.5 * j + 11.25), rounded(azimuth_in_turn(theta)));
        }
    }
    for (const glm::vec3& direction : pattern.directions) {
        CHECK(glm::length(direction) == Approx(1.f));
        const float azimuth = glm::degrees(std::atan2(direction.z, direction.x));
        found.emplace(rounded(polar_angle(direction)), rounded(azimuth_in_turn(azimuth)));
    }
    CHECK(found == published);
}

TEST_CASE("every principal direction owns an eighth of the rays, those in its octant", "[ddgi]") {
    const RayPattern pattern =
        GENERATE(thesis_pattern(64), thesis_pattern(96), thesis_pattern(160), even_pattern(64),
                 even_pattern(8), even_pattern(88), even_pattern(256));
    REQUIRE(pattern.per_octant() * octant_count == pattern.directions.size());
    for (std::size_t ray = 0; ray < pattern.directions.size(); ++ray) {
        const std::size_t d = ray / pattern.per_octant();
        const glm::vec3& direction = pattern.directions[ray];
        CHECK(std::abs(relative_azimuth(direction, d)) < 45.f);
        CHECK(direction.y * float(principal_directions[d].y) > 0.f);
    }
}

TEST_CASE("even rays balance, and integrate smooth functions over the sphere", "[ddgi]") {
    const int surfels = GENERATE(64, 96, 256, 1024);
    const RayPattern pattern = even_pattern(surfels);
    REQUIRE(pattern.size() == surfels);
    glm::dvec3 sum(0.);
    glm::dvec3 squares(0.);
    for (const glm::vec3& direction : pattern.directions) {
        sum += glm::dvec3(direction);
        squares += glm::dvec3(direction * direction);
    }
    CHECK(glm::length(sum) < 1e-4);
    // The mean of a squared coordinate over the sphere is 1/3; the thesis's rings give .5 for y.
    const glm::dvec3 error = glm::abs(squares / double(surfels) - 1. / 3.);
    CHECK(glm::max(error.x, glm::max(error.y, error.z)) < 4. / surfels);
}

TEST_CASE("even rays stand for equal solid angles", "[ddgi]") {
    // Bands of equal area in y hold equal numbers of rays, and so do turns of 90 degrees.
    const RayPattern pattern = even_pattern(GENERATE(64, 256));
    constexpr std::size_t bands = 16;
    std::array<int, bands> in_band{};
    std::array<double, 4> turned{};  // sums over the rays of a quarter turn
    for (const glm::vec3& direction : pattern.directions) {
        ++in_band[std::size_t((direction.y + 1.f) / 2.f * float(bands))];
        const double turn = std::atan2(direction.z, direction.x) / (2. * glm::pi<double>());
        turned[std::size_t((turn + 1.125) * 4.) % 4] += 1.;
    }
    for (const int count : in_band) CHECK(count == pattern.size() / int(bands));
    for (const double count : turned) CHECK(count == pattern.size() / 4.);
}

TEST_CASE("ray counts that a pattern does not have are refused with those it has", "[ddgi]") {
    CHECK_THROWS_WITH(thesis_pattern(72), Catch::Contains("64, 96, 128, 160"));
    CHECK_THROWS_AS(even_pattern(0), UsageError);
    CHECK_THROWS_AS(even_pattern(-8), UsageError);
    CHECK_THROWS_WITH(even_pattern(65), Catch::Contains("multiple of 8"));
}
