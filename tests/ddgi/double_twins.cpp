// SPDX-License-Identifier: Apache-2.0
// The probes' kernels in float against double twins, on seeded random inputs and on those at the
// edges of their domains. Bounds count roundings, each of 2^-24.
#include <catch2/catch.hpp>
#include <glm/gtc/constants.hpp>
#include <numeric>
#include <random>

#include "ddgi/octants.h"
#include "ddgi/patterns.h"
#include "ddgi/ray_gather.h"
#include "tests/worst_case.h"

using namespace plumbline;
using namespace plumbline::ddgi;

namespace {

constexpr unsigned seed = 20230614;
constexpr double eps = float_rounding;

glm::vec3 random_direction(std::mt19937& engine) {
    std::normal_distribution<float> normal;
    return glm::normalize(glm::vec3(normal(engine), normal(engine), normal(engine)));
}

/// Also along axes, edges of octants, and a hair off them.
glm::vec3 any_direction(std::mt19937& engine) {
    if (engine() % 2u == 0u) return random_direction(engine);
    std::uniform_int_distribution<int> coordinate(-1, 1);
    glm::vec3 v(coordinate(engine), coordinate(engine), coordinate(engine));
    if (v == glm::vec3(0.f)) v.y = 1.f;
    const float off = std::ldexp(1.f, -int(engine() % 60u));
    return glm::normalize(v + off * random_direction(engine));
}

/// The octant's cosine as one integral: by azimuth, with the polar one solved by hand.
///
/// Over directions (sin t cos p, cos t, sin t sin p) the integrand's polar part is
/// int max(0, a sin t + b cos t) sin t dt with a = n.x cos p + n.z sin p and b = n.y.
double polar_part(double a, double b, double from, double to) {
    // a sin t + b cos t is positive on one interval of [0, pi] or outside it: cut at its root.
    const auto antiderivative = [&](double t) {
        return a * (t / 2. - std::sin(2. * t) / 4.) + b * std::pow(std::sin(t), 2.) / 2.;
    };
    const auto height = [&](double t) { return a * std::sin(t) + b * std::cos(t); };
    double root = std::atan2(-b, a);
    if (root < 0.) root += glm::pi<double>();
    std::array<double, 3> cuts{from, std::clamp(root, from, to), to};
    double sum = 0.;
    for (std::size_t i = 0; i < 2; ++i) {
        if (height((cuts[i] + cuts[i + 1]) / 2.) <= 0.) continue;
        sum += antiderivative(cuts[i + 1]) - antiderivative(cuts[i]);
    }
    return sum;
}

/// By the midpoint rule over the azimuth.
double octant_cosine_by_integration(std::size_t octant, const glm::vec3& n) {
    constexpr int steps = 2000;
    const glm::ivec3 principal = principal_directions[octant];
    const double pi = glm::pi<double>();
    const double middle = std::atan2(double(principal.z), double(principal.x));
    const double from = principal.y > 0 ? 0. : pi / 2.;
    const double width = pi / 2. / steps;
    double sum = 0.;
    for (int i = 0; i < steps; ++i) {
        const double phi = middle - pi / 4. + (i + .5) * width;
        const double a = double(n.x) * std::cos(phi) + double(n.z) * std::sin(phi);
        sum += polar_part(a, double(n.y), from, from + pi / 2.) * width;
    }
    return double(sum);
}

/// A ray and what one gather in double makes of it, with the bound for float.
struct TwinWeight {
    double weight;
    double bound;
};

TwinWeight twin_weight(const glm::vec3& probe, const Surfels& surfels, std::size_t ray,
                       const glm::vec3& point, const glm::vec3& normal) {
    constexpr double flattest = double(1e-3f);
    const double most = double(RayEnds::most_magnified);
    const glm::dvec3 w(surfels.direction[ray]), ny(surfels.place[ray].n), n(normal);
    const double distance = double(surfels.place[ray].distance);
    const glm::dvec3 u = glm::dvec3(probe) + distance * w - glm::dvec3(point);
    const double d = glm::length(u);
    const double flatness = std::max(-glm::dot(ny, w), flattest);
    const double area = distance * distance / flatness;
    const double cosine = std::max(0., glm::dot(n, u)) / d;
    const double patch_cosine = std::max(0., -glm::dot(ny, u)) / d;
    const double ratio = area * patch_cosine / (d * d);
    // The ray's end is rounded where it stands, which turns and stretches the way to it.
    const double turned = 3. * eps * (glm::length(glm::dvec3(probe)) + 2. * distance) / d;
    const double of_cosine = turned + 6. * eps;
    const double of_area = (4. + 4. / flatness) * eps;
    const double of_ratio =
        std::min(most, ratio * (of_area + 2. * turned + 6. * eps) + area / (d * d) * of_cosine);
    return {cosine * std::clamp(ratio, 1. / most, most), most * of_cosine + cosine * of_ratio};
}

}  // namespace

TEST_CASE("octant cosines are their integrals on thousands of normals", "[ddgi][twins]") {
    std::mt19937 engine(seed);
    WorstCase worst, sum;
    for (int i = 0; i < 400; ++i) {
        const glm::vec3 n = any_direction(engine);
        const OctantCosines cosines = octant_cosines(n);
        const auto octant = std::size_t(engine() % octant_count);
        // The midpoint rule over 2000 steps is off by 1e-7 of the cosine at most: where the horizon
        // crosses the octant the integrand has a kink, and each kink costs a step squared.
        worst.add(double(cosines[octant]) - octant_cosine_by_integration(octant, n), 1e-6, n.x, n.y,
                  n.z, octant);
    }
    for (int i = 0; i < 20000; ++i) {
        const glm::vec3 n = any_direction(engine);
        const OctantCosines cosines = octant_cosines(n);
        const double total = std::accumulate(cosines.begin(), cosines.end(), 0.);
        // pi |n|: eight roundings to float, of weights that sum to pi, and the unit length's own.
        const double exact = glm::pi<double>() * glm::length(glm::dvec3(n));
        sum.add(total - exact, 2. * glm::pi<double>() * eps, n.x, n.y, n.z);
        for (const float cosine : cosines) REQUIRE(cosine >= -float(eps));
    }
    INFO("seed " << seed << ", worst at " << worst.input() << " and " << sum.input());
    CHECK(worst.share() <= 1.);
    CHECK(sum.share() <= 1.);
}

TEST_CASE("gather weights of rays in float are their double twins", "[ddgi][twins]") {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<float> uniform(-1.f, 1.f);
    constexpr std::size_t rays = 8;
    WorstCase worst;
    for (int i = 0; i < 2000; ++i) {
        const glm::vec3 probe(uniform(engine), uniform(engine), uniform(engine));
        Surfels surfels;
        surfels.resize(1, rays);
        for (std::size_t ray = 0; ray < rays; ++ray) {
            surfels.direction[ray] = any_direction(engine);
            surfels.place[ray].distance = std::pow(10.f, 3.f * uniform(engine));
            surfels.place[ray].n = any_direction(engine);
            if (glm::dot(surfels.place[ray].n, surfels.direction[ray]) > 0.f)
                surfels.place[ray].n *= -1.f;
        }
        RayEnds ends(surfels, 1.f);
        for (std::size_t ray = 0; ray < rays; ++ray) ends.set(0, ray, probe, surfels);
        const glm::vec3 x = probe + std::pow(10.f, 2.f * uniform(engine)) * any_direction(engine);
        const glm::vec3 n = any_direction(engine);
        for (std::size_t ray = 0; ray < rays; ++ray) {
            std::vector<float> radiance(3 * rays, 0.f);
            radiance[ray] = 1.f;  // its weight alone comes back in red
            const float weight = ends.from_point(0, x, n, radiance.data()).radiance.r;
            const TwinWeight twin = twin_weight(probe, surfels, ray, x, n);
            worst.add(double(weight) - twin.weight, twin.bound, "case", i, "ray", ray);
        }
    }
    INFO("seed " << seed << ", worst at " << worst.input());
    CHECK(worst.share() <= 1.);
}
