// SPDX-License-Identifier: Apache-2.0
#include "pathtracer/hemisphere.h"

#include <catch2/catch.hpp>
#include <random>
#include <vector>

#include "tests/pathtracer/statistics.h"

namespace plumbline::pathtracer {

TEST_CASE("directions on the hemisphere follow the cosine", "[pathtracer][sampler]") {
    constexpr int rings = 8, sectors = 16, n = 100'000;
    const std::vector<glm::vec3> normals{{0.f, 0.f, 1.f},  {0.f, 0.f, -1.f},     {1.f, 0.f, 0.f},
                                         {0.f, -1.f, 0.f}, {1e-4f, 1e-4f, -1.f}, {-3.f, 1.f, 2.f}};
    std::mt19937_64 random(7);
    std::uniform_real_distribution<float> uniform(0.f, 1.f);
    for (const glm::vec3& any_length : normals) {
        const glm::vec3 normal = glm::normalize(any_length);
        const glm::vec3 helper = std::abs(normal.x) < .5f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
        const glm::vec3 u = glm::normalize(glm::cross(helper, normal));
        const glm::vec3 v = glm::cross(normal, u);
        std::vector<double> observed(rings * sectors, 0.), expected;
        for (int i = 0; i < n; ++i) {
            const glm::vec3 wi =
                sample_cosine_hemisphere({uniform(random), uniform(random)}, normal);
            REQUIRE(glm::dot(wi, normal) > 0.f);
            REQUIRE(glm::length(wi) == Approx(1.f).margin(1e-6));
            const float z = std::min(glm::dot(wi, normal), .999999f);
            const float turn =
                std::atan2(glm::dot(wi, v), glm::dot(wi, u)) / (2.f * std::numbers::pi_v<float>);
            const int sector = std::min(int((turn + .5f) * sectors), sectors - 1);
            observed[std::size_t(int(z * rings) * sectors + sector)] += 1.;
        }
        // The integral of cos / pi over a ring of cosines [a, b] is b^2 - a^2.
        for (int cell = 0; cell < rings * sectors; ++cell) {
            const double a = double(cell / sectors) / rings;
            const double b = double(cell / sectors + 1) / rings;
            expected.push_back(n * (b * b - a * a) / sectors);
        }
        CHECK(std::abs(test::chi_square_z(observed, expected)) <
              test::sidak_limit(int(normals.size())));
    }
}

TEST_CASE("the density of cosine-weighted directions integrates to 1 over the sphere",
          "[pathtracer][sampler]") {
    constexpr int steps = 1000;
    double integral = 0.;
    for (int i = 0; i < steps; ++i) {
        const double cosine = -1. + 2. * (i + .5) / steps;
        integral += 2. * std::numbers::pi * pdf_cosine_hemisphere(float(cosine)) * 2. / steps;
    }
    CHECK(integral == Approx(1.).epsilon(1e-5));
}

TEST_CASE("the last number below 1 still gives a direction above the surface",
          "[pathtracer][sampler]") {
    const glm::vec3 n = glm::normalize(glm::vec3(1.f, 2.f, -3.f));
    const float last = std::nextafter(1.f, 0.f);
    CHECK(glm::dot(sample_cosine_hemisphere({last, last}, n), n) > 0.f);
}

}  // namespace plumbline::pathtracer
