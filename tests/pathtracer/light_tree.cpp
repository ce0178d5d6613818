// SPDX-License-Identifier: Apache-2.0
#include "pathtracer/light_tree.h"

#include <catch2/catch.hpp>
#include <random>

#include "tests/pathtracer/statistics.h"

namespace plumbline::pathtracer {
namespace {

class Random {
 public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    float number() { return std::uniform_real_distribution<float>(0.f, 1.f)(engine_); }
    glm::vec3 in_cube() { return 2.f * glm::vec3(number(), number(), number()) - 1.f; }
    glm::vec3 direction() {
        for (;;) {
            const glm::vec3 v = in_cube();
            const float length = glm::length(v);
            if (length > .1f && length < 1.f) return v / length;
        }
    }

 private:
    std::mt19937_64 engine_;
};

std::vector<LightBounds> random_lights(std::size_t count, Random& random) {
    std::vector<LightBounds> lights(count);
    for (LightBounds& light : lights) {
        const glm::vec3 at = 3.f * random.in_cube();
        light.box.extend(at);
        light.box.extend(at + .1f * random.in_cube());
        light.normals = {random.direction(), random.number() < .5f ? 0.f : random.number()};
        light.power = .1f + random.number();
        light.two_sided = random.number() < .3f;
    }
    return lights;
}

}  // namespace

TEST_CASE("a light tree's probabilities add up to 1 wherever any light is in reach",
          "[pathtracer][sampler]") {
    Random random(1);
    const auto count = GENERATE(std::size_t{1}, std::size_t{2}, std::size_t{7}, std::size_t{1000});
    const LightTree tree(random_lights(count, random));
    for (int point = 0; point < 20; ++point) {
        const glm::vec3 x = 4.f * random.in_cube();
        const glm::vec3 n = random.direction();
        double sum = 0.;
        for (std::uint32_t light = 0; light < count; ++light) {
            sum += double(tree.probability(light, x, n));
        }
        // Branches that end where no light is in reach keep the sum below 1.
        CHECK(sum < 1. + 1e-4);
        int chosen = 0;
        constexpr int n_choices = 1000;
        for (int i = 0; i < n_choices; ++i) {
            const float u = (static_cast<float>(i) + .5f) / n_choices;
            const auto choice = tree.choose(x, n, u);
            if (!choice) continue;
            ++chosen;
            CHECK(choice->probability ==
                  Approx(tree.probability(choice->light, x, n)).epsilon(1e-4));
        }
        CHECK(std::abs(chosen / double(n_choices) - sum) < .01 + 1e-9);
    }
}

TEST_CASE("lights are chosen as often as the tree says", "[pathtracer][sampler]") {
    Random random(2);
    constexpr std::size_t count = 60;
    const LightTree tree(random_lights(count, random));
    constexpr int points = 5, n = 100'000;
    for (int point = 0; point < points; ++point) {
        const glm::vec3 x = 2.f * random.in_cube();
        const glm::vec3 normal = random.direction();
        std::vector<double> seen(count + 1, 0.), expected(count + 1, 0.);
        for (int i = 0; i < n; ++i) {
            const auto choice = tree.choose(x, normal, random.number());
            seen[choice ? choice->light : count] += 1.;
        }
        expected[count] = n;
        for (std::uint32_t light = 0; light < count; ++light) {
            expected[light] = n * double(tree.probability(light, x, normal));
            expected[count] -= expected[light];
        }
        // Cells too small for Pearson's statistic are put together.
        constexpr double least = 10.;
        std::vector<double> cells_seen{0.}, cells_expected{0.};
        for (std::size_t i = 0; i <= count; ++i) {
            const bool small = expected[i] < least;
            if (!small) {
                cells_seen.push_back(seen[i]);
                cells_expected.push_back(expected[i]);
            } else {
                cells_seen[0] += seen[i];
                cells_expected[0] += expected[i];
            }
        }
        if (cells_expected[0] < least) {
            CHECK(cells_seen[0] < 4. * least);
            cells_seen.erase(cells_seen.begin());
            cells_expected.erase(cells_expected.begin());
        }
        CHECK(std::abs(::plumbline::test::chi_square_z(cells_seen, cells_expected)) <
              ::plumbline::test::sidak_limit(points));
    }
}

TEST_CASE("a joined cone holds both cones", "[pathtracer][sampler]") {
    Random random(3);
    for (int i = 0; i < 1000; ++i) {
        const DirectionCone a{random.direction(), 1.5f * random.number()};
        const DirectionCone b{random.direction(), 1.5f * random.number()};
        const DirectionCone all = joined(a, b);
        for (const DirectionCone& cone : {a, b}) {
            const float off = std::acos(glm::clamp(glm::dot(all.axis, cone.axis), -1.f, 1.f));
            CHECK(std::min(off + cone.angle, 3.1415927f) < all.angle + 2e-3f);
        }
    }
}

}  // namespace plumbline::pathtracer
