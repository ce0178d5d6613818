// SPDX-License-Identifier: Apache-2.0
#include "compare/flip.h"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "compare/flip_color.h"
#include "compare/flip_filters.h"
#include "scenes/errors.h"
#include "tests/compare/test_images.h"

using namespace plumbline;
using namespace plumbline::compare;
using Catch::WithinAbs;

namespace {

// The second formulation: FLIP as the paper writes it, with whole two-dimensional kernels in double
// precision where the program takes products of one-dimensional ones in tiles.

using Grid = std::vector<double>;
constexpr double ppd = 0.7 * (3840 / 0.7) * (std::numbers::pi / 180);

struct Kernel {
    int radius;
    Grid weights;
};

Kernel contrast_kernel(double a1, double b1, double a2, double b2) {
    const double pi = std::numbers::pi;
    Kernel k{int(std::ceil(3 * std::sqrt(0.04 / (2 * pi * pi)) * ppd)), {}};
    double sum = 0;
    for (int y = -k.radius; y <= k.radius; ++y)
        for (int x = -k.radius; x <= k.radius; ++x) {
            const double z = (x * x + y * y) / (ppd * ppd);
            k.weights.push_back(a1 * std::sqrt(pi / b1) * std::exp(-pi * pi * z / b1) +
                                a2 * std::sqrt(pi / b2) * std::exp(-pi * pi * z / b2));
            sum += k.weights.back();
        }
    for (double& weight : k.weights) weight /= sum;
    return k;
}

/// `order` 1: edges, 2: points; along x, or along y.
Kernel feature_kernel(int order, bool along_x) {
    const double sd = 0.5 * 0.082 * ppd;
    Kernel k{int(std::ceil(3 * sd)), {}};
    double positive = 0, negative = 0;
    for (int y = -k.radius; y <= k.radius; ++y)
        for (int x = -k.radius; x <= k.radius; ++x) {
            const double u = along_x ? x : y;
            const double g = std::exp(-(x * x + y * y) / (2 * sd * sd));
            const double w = order == 1 ? -u * g : (u * u / (sd * sd) - 1) * g;
            (w > 0 ? positive : negative) += std::abs(w);
            k.weights.push_back(w);
        }
    for (double& w : k.weights) w /= w > 0 ? positive : negative;
    return k;
}

double filtered(const Grid& in, int width, int height, const Kernel& k, int x, int y) {
    double sum = 0;
    std::size_t i = 0;
    for (int dy = -k.radius; dy <= k.radius; ++dy)
        for (int dx = -k.radius; dx <= k.radius; ++dx, ++i) {
            const int u = std::min(std::max(x + dx, 0), width - 1);
            const int v = std::min(std::max(y + dy, 0), height - 1);
            sum += k.weights[i] * in[std::size_t(v * width + u)];
        }
    return sum;
}

/// CIE XYZ relative to the white point from linear sRGB, by the matrix of [IEC 61966-2-1] in the
/// rational form in which FLIP's authors give it; its row sums are the white point.
glm::dvec3 white_relative_xyz(const glm::dvec3& rgb) {
    const glm::dvec3 x(10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794);
    const glm::dvec3 y(2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897);
    const glm::dvec3 z(1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382);
    const auto ratio = [&](const glm::dvec3& row) {
        return glm::dot(row, rgb) / (row.x + row.y + row.z);
    };
    return {ratio(x), ratio(y), ratio(z)};
}

glm::dvec3 opponent(const glm::dvec3& rgb) {
    const glm::dvec3 v = white_relative_xyz(rgb);
    return {116 * v.y - 16, 500 * (v.x - v.y), 200 * (v.y - v.z)};
}

/// The inverse of opponent(), from its values at the unit vectors.
glm::dvec3 rgb_of_opponent(const glm::dvec3& v) {
    const glm::dvec3 zero = opponent(glm::dvec3(0));
    const glm::dmat3 linear(opponent({1, 0, 0}) - zero, opponent({0, 1, 0}) - zero,
                            opponent({0, 0, 1}) - zero);
    return glm::inverse(linear) * (v - zero);
}

/// CIELAB (CIE 15:2004) with Hunt's adjustment.
glm::dvec3 hunt_lab(const glm::dvec3& rgb) {
    const auto f = [](double t) {
        const double d = 6.0 / 29;
        return t > d * d * d ? std::cbrt(t) : t / (3 * d * d) + 4.0 / 29;
    };
    const glm::dvec3 v = white_relative_xyz(rgb);
    const double L = 116 * f(v.y) - 16;
    return {L, 0.01 * L * 500 * (f(v.x) - f(v.y)), 0.01 * L * 200 * (f(v.y) - f(v.z))};
}

double hyab_distance(const glm::dvec3& a, const glm::dvec3& b) {
    return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

struct Planes {
    std::array<Grid, 3> ycxcz;
    Grid gray;
};

Planes planes_of(const Image& image) {
    Planes planes;
    const auto layer = image.layer("");
    for (std::size_t i = 0; i < image.pixels(); ++i) {
        const auto channel = [&](std::size_t c) { return glm::clamp(layer[c][i], 0.f, 1.f); };
        const glm::dvec3 v = opponent({channel(0), channel(1), channel(2)});
        planes.ycxcz[0].push_back(v.x);
        planes.ycxcz[1].push_back(v.y);
        planes.ycxcz[2].push_back(v.z);
        planes.gray.push_back((v.x + 16) / 116);
    }
    return planes;
}

double reference_error(double distance) {
    const double largest = std::pow(hyab_distance(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1})), 0.7);
    const double e = std::pow(distance, 0.7);
    return e < 0.4 * largest ? 0.95 * e / (0.4 * largest)
                             : 0.95 + 0.05 * (e - 0.4 * largest) / (0.6 * largest);
}

Grid reference_ldr_flip(const Image& r, const Image& t) {
    const int w = r.width(), h = r.height();
    const std::array<Kernel, 3> contrast{contrast_kernel(1, 0.0047, 0, 1e-5),
                                         contrast_kernel(1, 0.0053, 0, 1e-5),
                                         contrast_kernel(34.1, 0.04, 13.5, 0.025)};
    const std::array<Planes, 2> planes{planes_of(r), planes_of(t)};
    const std::array<std::array<Kernel, 2>, 2> features{
        {{feature_kernel(1, true), feature_kernel(1, false)},
         {feature_kernel(2, true), feature_kernel(2, false)}}};
    Grid map;
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            std::array<glm::dvec3, 2> color;
            std::array<std::array<double, 2>, 2> feature{};  // edges, points
            for (std::size_t k = 0; k < 2; ++k) {
                glm::dvec3 v;
                for (std::size_t c = 0; c < 3; ++c)
                    v[int(c)] = filtered(planes[k].ycxcz[c], w, h, contrast[c], x, y);
                color[k] = hunt_lab(glm::clamp(rgb_of_opponent(v), 0.0, 1.0));
                for (std::size_t order : {0, 1})
                    feature[k][order] =
                        std::hypot(filtered(planes[k].gray, w, h, features[order][0], x, y),
                                   filtered(planes[k].gray, w, h, features[order][1], x, y));
            }
            const double f = std::sqrt(std::max(std::abs(feature[0][0] - feature[1][0]),
                                                std::abs(feature[0][1] - feature[1][1])) /
                                       std::sqrt(2.0));
            map.push_back(std::pow(reference_error(hyab_distance(color[0], color[1])), 1 - f));
        }
    return map;
}

double mean_of(const Grid& grid) {
    double sum = 0;
    for (double value : grid) sum += value;
    return sum / double(grid.size());
}

/// A bright edge that the test moves by a pixel, over a coloured ramp.
Image edge_image(int width, int height, int edge, float scale) {
    return image_of(width, height, [=](int x, int y, int c) {
        const float ramp = 0.02f * float(y + 1) * float(c + 1);
        return scale * (x < edge ? 0.7f : 0.05f) + ramp;
    });
}

}  // namespace

TEST_CASE("ldr-flip equals the paper's two-dimensional formulation", "[compare]") {
    const Image r = edge_image(15, 12, 7, 1.f);
    const Image t = GENERATE(edge_image(15, 12, 8, 1.f), noise_image(15, 12, 3, 1.f));
    const FlipResult flip = ldr_flip(pair_layers(r, t, ""));
    const Grid expected = reference_ldr_flip(r, t);
    for (std::size_t i = 0; i < expected.size(); ++i)
        CHECK_THAT(double(flip.map[i]), WithinAbs(expected[i], 1e-4));
    CHECK_THAT(flip.mean, WithinAbs(mean_of(expected), 1e-5));
}

TEST_CASE("flip gives the values of its authors' implementation", "[compare]") {
    // Run on the same pictures: mean, and the pixels below.
    struct Published {
        const char* tone_mapper;  ///< none: LDR
        double mean;
        std::array<double, 4> pixels;
    };
    const Published published =
        GENERATE(Published{"", 0.486972, {0.601845, 0.495965, 0.593672, 0.370494}},
                 Published{"aces", 0.431285, {0.800457, 0.488453, 0.641055, 0.323823}},
                 Published{"hable", 0.423613, {0.773374, 0.446787, 0.630384, 0.320616}},
                 Published{"reinhard", 0.460622, {0.810218, 0.545204, 0.764590, 0.278728}});
    constexpr std::array<std::array<int, 2>, 4> places{{{0, 0}, {20, 10}, {47, 31}, {31, 5}}};
    const std::string mapper = published.tone_mapper;
    const float scale = mapper.empty() ? 1.f : 8.f;
    const auto pattern = [&](int offset, float gain) {
        return image_of(48, 32, [=](int x, int y, int c) {
            return scale * gain * float((x * (c + 2) + 3 * y + offset) % 32) / 31.f;
        });
    };
    const Image reference = pattern(0, 1.f), test = pattern(5, 0.9f);
    const LayerPair pair = pair_layers(reference, test, "");
    FlipOptions options;
    if (!mapper.empty()) options.tone_mapper = tone_mapper(mapper);
    const FlipResult flip = mapper.empty() ? ldr_flip(pair) : hdr_flip(pair, options).value();
    CHECK_THAT(flip.mean, WithinAbs(published.mean, 1e-4));
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto [x, y] = places[i];
        CHECK_THAT(double(flip.map[std::size_t(y * 48 + x)]), WithinAbs(published.pixels[i], 1e-4));
    }
}

TEST_CASE("flip does not depend on where its tiles lie", "[compare]") {
    // Wider and higher than one tile; the picture repeats, so the interior must repeat too.
    const int period = 64;
    const auto pattern = [&](int offset) {
        return image_of(5 * period, 2 * period, [=](int x, int y, int c) {
            const int u = (x + offset) % period;
            return 0.5f + 0.4f * std::sin(float(u * (c + 1) + y % period) * 0.1f);
        });
    };
    const FlipResult flip = ldr_flip(pair_layers(pattern(0), pattern(5), ""));
    const std::size_t width = 5 * period;
    for (int y = 20; y < 100; ++y)
        for (int x = 20; x < 4 * period - 20; ++x) {
            const std::size_t i = std::size_t(y) * width + std::size_t(x);
            REQUIRE_THAT(double(flip.map[i]), WithinAbs(double(flip.map[i + period]), 1e-6));
        }
}

TEST_CASE("flip of black and white is the colour error alone", "[compare]") {
    // Flat pictures have no features, and white differs from black by L* = 100:
    // 0.95 + 0.05 (100^0.7 - 0.4 m) / (0.6 m), m = 41.28 the largest distance to the power 0.7.
    const Image black = image_of(8, 8, [](int, int, int) { return 0.f; });
    const Image white = image_of(8, 8, [](int, int, int) { return 1.f; });
    CHECK_THAT(ldr_flip(pair_layers(black, white, "")).mean, WithinAbs(0.967391, 2e-5));
    CHECK_THAT(ldr_flip(pair_layers(white, black, "")).mean, WithinAbs(0.967391, 2e-5));
}

TEST_CASE("hdr-flip is the largest ldr-flip over the authors' exposures", "[compare]") {
    const Image r = edge_image(13, 12, 6, 20.f), t = edge_image(13, 12, 7, 20.f);
    const auto flip = hdr_flip(pair_layers(r, t, ""));
    REQUIRE(flip);

    // ACES takes 0.85 where 2.51 v^2 + 0.03 v = 0.85 (2.43 v^2 + 0.59 v + 0.14), v = 0.6 x.
    const double a = 2.51 - 0.85 * 2.43, b = 0.03 - 0.85 * 0.59, c = -0.85 * 0.14;
    const double x = (-b + std::sqrt(b * b - 4 * a * c)) / (2 * a) / 0.6;
    std::vector<double> luminances;
    const auto layer = r.layer("");
    for (std::size_t i = 0; i < r.pixels(); ++i)
        luminances.push_back(0.2126 * double(layer[0][i]) + 0.7152 * double(layer[1][i]) +
                             0.0722 * double(layer[2][i]));
    std::sort(luminances.begin(), luminances.end());
    const double median = 0.5 * (luminances[77] + luminances[78]);
    const double start = std::log2(x / luminances.back()), stop = std::log2(x / median);
    CHECK_THAT(flip->start_exposure, WithinAbs(start, 1e-5));
    CHECK_THAT(flip->stop_exposure, WithinAbs(stop, 1e-5));
    const int count = std::max(2, int(std::ceil(stop - start)));
    REQUIRE(flip->exposures == count);

    Grid largest(r.pixels(), 0);
    for (int i = 0; i < count; ++i) {
        const double scale = std::exp2(start + (stop - start) * i / (count - 1));
        const auto shown = [&](const Image& image) {
            return image_of(13, 12, [&, layers = image.layer("")](int u, int v, int k) {
                const double e =
                    0.6 * scale * double(layers[std::size_t(k)][std::size_t(v * 13 + u)]);
                return float(e * (2.51 * e + 0.03) / (e * (2.43 * e + 0.59) + 0.14));
            });
        };
        const Grid map = reference_ldr_flip(shown(r), shown(t));
        for (std::size_t k = 0; k < map.size(); ++k) largest[k] = std::max(largest[k], map[k]);
    }
    CHECK_THAT(flip->mean, WithinAbs(mean_of(largest), 1e-5));
}

TEST_CASE("hdr-flip with another tone mapper is ldr-flip of what that one shows", "[compare]") {
    const Image r = edge_image(13, 12, 6, 20.f), t = edge_image(13, 12, 7, 20.f);
    const bool hable = GENERATE(true, false);
    FlipOptions options;
    options.tone_mapper = tone_mapper(hable ? "hable" : "reinhard");
    const auto flip = hdr_flip(pair_layers(r, t, ""), options);
    REQUIRE(flip);
    Grid largest(r.pixels(), 0);
    for (int k = 0; k < flip->exposures; ++k) {
        const double scale =
            std::exp2(flip->start_exposure +
                      (flip->stop_exposure - flip->start_exposure) * k / (flip->exposures - 1));
        const auto shown = [&](const Image& image) {
            return image_of(13, 12, [&, layers = image.layer("")](int x, int y, int c) {
                const auto at = [&](std::size_t channel) {
                    return scale * double(layers[channel][std::size_t(y * 13 + x)]);
                };
                const double e = at(std::size_t(c));
                // The published coefficients of either.
                if (hable)
                    return float((0.231683 * e * e + 0.013791 * e) /
                                 (0.18 * e * e + 0.3 * e + 0.018));
                return float(e / (1 + 0.2126 * at(0) + 0.7152 * at(1) + 0.0722 * at(2)));
            });
        };
        const Grid map = reference_ldr_flip(shown(r), shown(t));
        for (std::size_t i = 0; i < map.size(); ++i) largest[i] = std::max(largest[i], map[i]);
    }
    CHECK_THAT(flip->mean, WithinAbs(mean_of(largest), 1e-5));
}

TEST_CASE("hdr-flip needs light in the reference", "[compare]") {
    const Image black = image_of(8, 8, [](int, int, int) { return 0.f; });
    const Image gray = image_of(8, 8, [](int, int, int) { return 0.5f; });
    CHECK_FALSE(hdr_flip(pair_layers(black, gray, "")));
    // More than half of it black: the median of what is lit sets the stop exposure.
    const Image mostly_black =
        image_of(8, 8, [](int x, int, int) { return x < 6 ? 0.f : float(x); });
    const auto flip = hdr_flip(pair_layers(mostly_black, gray, ""));
    REQUIRE(flip);
    CHECK_THAT(flip->stop_exposure - flip->start_exposure, WithinAbs(std::log2(7 / 6.5), 1e-5));
}

TEST_CASE("hdr-flip takes the exposures that it is given", "[compare]") {
    const Image r = edge_image(13, 12, 6, 20.f), t = edge_image(13, 12, 7, 20.f);
    FlipOptions options;
    options.start_exposure = -4;
    options.stop_exposure = 1.5;
    const auto flip = hdr_flip(pair_layers(r, t, ""), options);
    REQUIRE(flip);
    CHECK(flip->exposures == 6);
    CHECK(flip->start_exposure == -4);
    CHECK(flip->stop_exposure == 1.5);
    options.stop_exposure = -5;
    CHECK_THROWS_AS(hdr_flip(pair_layers(r, t, ""), options), UsageError);
}

TEST_CASE("a nearer viewer sees more of a difference", "[compare]") {
    const Image r = noise_image(40, 40, 1, 1.f), t = noise_image(40, 40, 2, 1.f);
    FlipOptions far, near;
    far.pixels_per_degree = 100;
    near.pixels_per_degree = 20;
    CHECK(ldr_flip(pair_layers(r, t, ""), near).mean > ldr_flip(pair_layers(r, t, ""), far).mean);
}

TEST_CASE("very bright and negative values do not break the tone mapper", "[compare]") {
    const ToneMapper mapper = GENERATE(ToneMapper::Aces, ToneMapper::Hable, ToneMapper::Reinhard);
    const ToneCurve& curve = tone_curve(mapper);
    if (mapper == ToneMapper::Aces) CHECK_THAT(double(curve(3e38f)), WithinAbs(2.51 / 2.43, 1e-6));
    CHECK(std::isfinite(curve(-3e38f)));
    CHECK_THAT(double(curve(1.f)), WithinAbs(double(curve(1.0000001f)), 1e-6));
    CHECK_THAT(curve.inverse(double(curve(0.7f))), WithinAbs(0.7, 1e-5));
}

TEST_CASE("the cube root is that of the library", "[compare]") {
    for (float t = 0.005f; t < 2.f; t *= 1.003f)
        CHECK(double(cube_root(t)) == Approx(std::cbrt(double(t))).epsilon(4e-7));
}
