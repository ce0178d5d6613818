// SPDX-License-Identifier: Apache-2.0
#include "pathtracer/sampler.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <set>
#include <vector>

#include "tests/pathtracer/statistics.h"

namespace plumbline::pathtracer {
namespace {

constexpr int pairs = 12;
constexpr int cells = 16;  // along each axis

/// The first pairs of dimensions of a sample.
std::array<glm::vec2, pairs> points(std::uint64_t key, int sample) {
    Sampler sampler(key, sample);
    std::array<glm::vec2, pairs> result;
    for (glm::vec2& point : result) point = sampler.next_2d();
    return result;
}

/// How uneven `draw(i)`, points of [0,1)^2 for i < n, lie in 16 x 16 cells: see chi_square_z().
template <typename Draw>
double unevenness(int n, const Draw& draw) {
    std::vector<double> observed(cells * cells, 0.);
    for (int i = 0; i < n; ++i) {
        const glm::ivec2 cell = glm::ivec2(draw(i) * float(cells));
        observed[std::size_t(cell.y * cells + cell.x)] += 1.;
    }
    const std::vector<double> expected(cells * cells, double(n) / (cells * cells));
    return test::chi_square_z(observed, expected);
}

constexpr int draws = 20'000;

}  // namespace

TEST_CASE("the numbers of a sample are at least 0 and below 1", "[pathtracer][sampler]") {
    float least = 1.f;
    float most = 0.f;
    for (int pixel = 0; pixel < 5'000; ++pixel) {
        for (const glm::vec2& point : points(pixel_key(3, pixel, 0), pixel % 64)) {
            least = std::min({least, point.x, point.y});
            most = std::max({most, point.x, point.y});
        }
    }
    CHECK(least >= 0.f);
    CHECK(least < 1e-3f);
    CHECK(most < 1.f);
    CHECK(most > 1.f - 1e-3f);
}

TEST_CASE("each pair of dimensions of a batch has one point in every elementary interval",
          "[pathtracer][sampler]") {
    for (int batch = 0; batch < 50; ++batch) {
        for (int pair = 0; pair < pairs; ++pair) {
            for (int x_digits = 0; x_digits <= 4; ++x_digits) {
                const glm::vec2 intervals(1 << x_digits, 16 >> x_digits);
                std::set<std::pair<int, int>> met;
                for (int i = 0; i < Sampler::batch_size; ++i) {
                    const auto point = points(pixel_key(0, 1, 2),
                                              batch * Sampler::batch_size + i)[std::size_t(pair)];
                    const glm::ivec2 interval(point * intervals);
                    met.emplace(interval.x, interval.y);
                }
                REQUIRE(met.size() == 16);
            }
        }
    }
}

TEST_CASE("each pair of dimensions is uniform for every sample of a batch",
          "[pathtracer][sampler]") {
    const double limit = test::sidak_limit(pairs * 3);
    for (const int sample : {0, 7, 31}) {
        for (std::size_t pair = 0; pair < pairs; ++pair) {
            CHECK(std::abs(unevenness(draws, [&](int i) {
                      return points(pixel_key(0, i % 640, i / 640), sample)[pair];
                  })) < limit);
        }
    }
}

TEST_CASE("pairs of dimensions are independent of each other", "[pathtracer][sampler]") {
    const double limit = test::sidak_limit(4 * (pairs - 1));
    // Over pixels: one sample each. Over a batch's samples: they must not share their order.
    for (std::size_t pair = 1; pair < pairs; ++pair) {
        for (const int axis : {0, 1}) {
            CHECK(std::abs(unevenness(draws, [&](int i) {
                      const auto p = points(pixel_key(1, i, 0), 5);
                      return glm::vec2(p[0][axis], p[pair][axis]);
                  })) < limit);
            CHECK(std::abs(unevenness(draws, [&](int i) {
                      const auto p = points(pixel_key(1, i, 1), i % Sampler::batch_size);
                      return glm::vec2(p[pair - 1][1 - axis], p[pair][axis]);
                  })) < limit);
        }
    }
}

TEST_CASE("pairs of dimensions take the points of a batch in orders of their own",
          "[pathtracer][sampler]") {
    // Of each two points that follow each other in the Sobol sequence, one lies in either half. So
    // with orders that keep such twos but are random else, the points in the lower halves of two
    // pairs of dimensions at once are binomial: 8 trials of 1/2, variance 2. In one shared order
    // there would be 0 or 8, and the four dimensions would be filled badly.
    constexpr int batches = 4'000;
    double squares = 0.;
    for (int batch = 0; batch < batches; ++batch) {
        int both = 0;
        for (int i = 0; i < Sampler::batch_size; ++i) {
            const auto p = points(pixel_key(2, batch, 0), i);
            both += p[3].x < .5f && p[4].x < .5f ? 1 : 0;
        }
        squares += (both - 4.) * (both - 4.);
    }
    // The square's own variance is 7 (the fourth central moment of that binomial, 11, less 4).
    CHECK(std::abs(squares / batches - 2.) < 4. * std::sqrt(7. / batches));
}

TEST_CASE("both axes of a pair of dimensions are scrambled", "[pathtracer][sampler]") {
    // The points in the first and third sixteenth along one axis share a half along the other as
    // often as not: which of them do is what scrambling the axis decides.
    constexpr int batches = 4'000;
    for (const int axis : {0, 1}) {
        int shared = 0;
        for (int batch = 0; batch < batches; ++batch) {
            float first = 0.f;
            float third = 0.f;
            for (int i = 0; i < Sampler::batch_size; ++i) {
                const glm::vec2 p = points(pixel_key(4, batch, 0), i)[1];
                const int sixteenth = int(p[axis] * 16.f);
                if (sixteenth == 0) first = p[1 - axis];
                if (sixteenth == 2) third = p[1 - axis];
            }
            shared += (first < .5f) == (third < .5f) ? 1 : 0;
        }
        CHECK(std::abs(shared - batches / 2.) < 4. * std::sqrt(batches / 4.));
    }
}

TEST_CASE("pixels, batches and seeds are independent of each other", "[pathtracer][sampler]") {
    const double limit = test::sidak_limit(4);
    const auto x_of = [](std::uint64_t seed, int x, int y, int sample) {
        return points(pixel_key(seed, x, y), sample)[0].x;
    };
    CHECK(std::abs(unevenness(draws, [&](int i) {
              return glm::vec2(x_of(0, 2 * i, 0, 0), x_of(0, 2 * i + 1, 0, 0));
          })) < limit);
    CHECK(std::abs(unevenness(draws, [&](int i) {
              return glm::vec2(x_of(0, 0, i, 0), x_of(0, 1, i, 0));
          })) < limit);
    CHECK(std::abs(unevenness(draws, [&](int i) {
              return glm::vec2(x_of(0, i, 0, 3), x_of(0, i, 0, 3 + Sampler::batch_size));
          })) < limit);
    CHECK(std::abs(unevenness(draws, [&](int i) {
              return glm::vec2(x_of(0, i, 0, 3), x_of(1, i, 0, 3));
          })) < limit);
}

}  // namespace plumbline::pathtracer
