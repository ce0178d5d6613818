// SPDX-License-Identifier: Apache-2.0
#include "ddgi/octants.h"

#include <catch2/catch.hpp>
#include <glm/gtc/constants.hpp>
#include <random>

using namespace plumbline;
using namespace plumbline::ddgi;

namespace {

constexpr double pi = glm::pi<double>();

glm::vec3 random_normal(std::mt19937& random) {
    std::normal_distribution<float> gauss;
    return glm::normalize(glm::vec3(gauss(random), gauss(random), gauss(random)));
}

/// W_d(n) by the midpoint rule in cos(polar angle) and azimuth, an area-preserving map.
double integrated(const glm::ivec3& principal, const glm::vec3& n) {
    constexpr int steps = 400;
    const double middle = std::atan2(principal.z, principal.x);
    double sum = 0.;
    for (int i = 0; i < steps; ++i) {
        const double y = (i + .5) / steps;
        for (int j = 0; j < steps; ++j) {
            const double azimuth = middle + pi / 2. * ((j + .5) / steps - .5);
            const glm::dvec3 w(std::sqrt(1. - y * y) * std::cos(azimuth), y * principal.y,
                               std::sqrt(1. - y * y) * std::sin(azimuth));
            sum += glm::max(0., glm::dot(w, glm::dvec3(n)));
        }
    }
    return sum * (pi / 2.) / (double(steps) * steps);
}

const std::vector<glm::vec3> axes = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                     {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};

}  // namespace

TEST_CASE("the closed form of W_d agrees with numeric integration", "[ddgi][analytic]") {
    std::mt19937 random(3);
    std::vector<glm::vec3> normals = axes;
    normals.push_back(glm::normalize(glm::vec3(1, 0, 1)));  // along an octant's corner
    for (int i = 0; i < 8; ++i) normals.push_back(random_normal(random));
    for (const glm::vec3& n : normals) {
        const auto W = octant_cosines(n);
        for (std::size_t d = 0; d < octant_count; ++d) {
            INFO("n = (" << n.x << ", " << n.y << ", " << n.z << "), d = " << d);
            CHECK(W[d] == Approx(integrated(principal_directions[d], n)).margin(5e-5));
        }
    }
}

TEST_CASE("the octants' cosines sum to pi for every normal, none of them negative",
          "[ddgi][analytic]") {
    std::mt19937 random(4);
    std::vector<glm::vec3> normals = axes;
    for (int i = 0; i < 20'000; ++i) normals.push_back(random_normal(random));
    for (const glm::vec3& n : normals) {
        const auto W = octant_cosines(n);
        double sum = 0.;
        for (const float w : W) {
            REQUIRE(w > -1e-7f);
            sum += double(w);
        }
        REQUIRE(sum == Approx(pi).epsilon(1e-6));
    }
}

TEST_CASE("straight up, each of the four upper octants gathers pi / 4", "[ddgi][analytic]") {
    const auto W = octant_cosines({0.f, 1.f, 0.f});
    for (std::size_t d = 0; d < octant_count; ++d) {
        CHECK(W[d] == Approx(d < 4 ? pi / 4. : 0.).margin(1e-7));
    }
}
