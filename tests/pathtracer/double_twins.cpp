// SPDX-License-Identifier: Apache-2.0
// The sampling kernels in float against the same formulas in double, on seeded random inputs and on
// those at the edges of their domains. Bounds count roundings, each of 2^-24.
#include <catch2/catch.hpp>
#include <numbers>
#include <random>

#include "pathtracer/lights.h"
#include "tests/worst_case.h"

using namespace plumbline;
using namespace plumbline::pathtracer;

namespace {

constexpr unsigned seed = 20230614;
constexpr int random_cases = 20000;
constexpr double eps = float_rounding;
const float just_below_one = std::nextafter(1.f, 0.f);

std::string text(const glm::vec3& v) {
    std::ostringstream out;
    out.precision(9);
    out << '(' << v.x << ' ' << v.y << ' ' << v.z << ')';
    return out.str();
}

/// Numbers of [0,1), among them its ends, and directions, among them those along axes and where the
/// basis of from_local() changes.
class Inputs {
 public:
    float unit() {
        constexpr float edges[] = {0.f, 0x1p-149f, 0x1p-24f, .25f, .5f, .75f};
        const int pick = int(engine_() % 16u);
        if (pick < 6) return edges[pick];
        return pick == 6 ? just_below_one : std::uniform_real_distribution<float>()(engine_);
    }
    glm::vec2 square() { return {unit(), unit()}; }
    glm::vec3 direction() {
        const float tiny = std::ldexp(1.f, -int(engine_() % 40u));
        switch (engine_() % 8u) {
            case 0:
                return {0.f, 0.f, -1.f};
            case 1:
                return {1.f, 0.f, -0.f};
            case 2:
                return glm::normalize(glm::vec3(tiny, -tiny, -1.f));
            case 3:
                return glm::normalize(glm::vec3(.6f, .8f, -tiny * 0x1p-10f));
            default:
                break;
        }
        std::normal_distribution<float> normal;
        return glm::normalize(glm::vec3(normal(engine_), normal(engine_), normal(engine_)));
    }
    /// 10 to an even power between the two.
    float magnitude(float lowest, float highest) {
        return std::pow(10.f, std::uniform_real_distribution<float>(lowest, highest)(engine_));
    }

 private:
    std::mt19937 engine_{seed};
};

glm::dvec3 twin_from_local(const glm::dvec3& local, const glm::dvec3& n) {
    const double sign = std::copysign(1., n.z);
    const double a = -1. / (sign + n.z);
    const double b = n.x * n.y * a;
    return glm::dvec3(1. + sign * n.x * n.x * a, sign * b, -sign * n.x) * local.x +
           glm::dvec3(b, sign + n.y * n.y * a, -n.y) * local.y + n * local.z;
}

glm::dvec3 twin_around(double sine, double cosine, double turn, const glm::vec3& axis) {
    const double phi = 2. * std::numbers::pi * turn;
    return twin_from_local({sine * std::cos(phi), sine * std::sin(phi), cosine}, glm::dvec3(axis));
}

/// Of a point of the unit circle: the angle, at most pi / 4 after the turn by whole quarters, has
/// two roundings, and the polynomials' last sums one each.
constexpr double circle_roundings = 4.;
/// Of from_local() and of a point of the unit circle: the products with the basis are off by 4
/// roundings each, the basis itself by 5, their sum by 3.
constexpr double turning_roundings = circle_roundings + 3. * (4. + 5.) + 3.;

struct TwinCone {
    double d2, sin2, one_minus_cos;
};

TwinCone twin_cone(const glm::vec3& to_center, float radius) {
    const double d2 = glm::dot(glm::dvec3(to_center), glm::dvec3(to_center));
    const double sin2 = double(radius) * double(radius) / d2;
    return {d2, sin2, sin2 / (1. + std::sqrt(1. - sin2))};
}

}  // namespace

TEST_CASE("points of the unit circle in float are their double twins to 4 roundings",
          "[pathtracer][twins]") {
    Inputs inputs;
    WorstCase worst;
    for (int i = 0; i < random_cases; ++i) {
        const float turn = inputs.unit();
        const double phi = 2. * std::numbers::pi * double(turn);
        const glm::dvec2 error =
            glm::dvec2(unit_circle(turn)) - glm::dvec2(std::cos(phi), std::sin(phi));
        worst.add(glm::length(error), circle_roundings * eps, turn);
    }
    INFO("seed " << seed << ", worst at " << worst.input());
    CHECK(worst.share() <= 1.);
}

TEST_CASE("cosine sampling in float is its double twin to 34 roundings", "[pathtracer][twins]") {
    Inputs inputs;
    WorstCase worst;
    for (int i = 0; i < random_cases; ++i) {
        const glm::vec2 u = inputs.square();
        const glm::vec3 n = inputs.direction();
        const double x = double(u.x);
        const glm::dvec3 twin = twin_around(std::sqrt(x), std::sqrt(1. - x), double(u.y), n);
        const double error = glm::length(glm::dvec3(sample_cosine_hemisphere(u, n)) - twin);
        // 1 - u.x near 0 is exact, and so its root has one rounding.
        worst.add(error, turning_roundings * eps, u.x, u.y, text(n));
    }
    INFO("seed " << seed << ", worst at " << worst.input());
    CHECK(worst.share() <= 1.);
}

TEST_CASE("a sphere's cone in float is its double twin from a speck to a wall",
          "[pathtracer][twins]") {
    Inputs inputs;
    WorstCase angle, direction;
    for (int i = 0; i < random_cases; ++i) {
        const float distance = inputs.magnitude(-6.f, 6.f);
        const glm::vec3 to_center = distance * inputs.direction();
        // From 1e-7 of the distance to all but 1e-6 of it.
        const float part =
            i % 2 == 0 ? inputs.magnitude(-7.f, -.01f) : 1.f - inputs.magnitude(-5.5f, -.5f);
        const float radius = part * glm::length(to_center);
        const SphereCone cone = sphere_cone(to_center, radius);
        const TwinCone twin = twin_cone(to_center, radius);
        // sin^2 has five roundings. Where the sphere all but touches, 1 - sin^2 cancels, and its
        // root passes them on divided by 2 cos.
        const double roundings = 5. + 4. + 5. / (2. * std::sqrt(1. - twin.sin2));
        angle.add(double(cone.one_minus_cos) / twin.one_minus_cos - 1., roundings * eps, distance,
                  part, text(to_center));
        const glm::vec2 u = inputs.square();
        const double lower = double(u.x) * twin.one_minus_cos;
        const glm::dvec3 exact =
            twin_around(std::sqrt(lower * (2. - lower)), 1. - lower, double(u.y), cone.axis);
        // An error of 1 - cos moves the direction by it over the sine: by sqrt(2 (1 - cos)) at
        // most.
        const double moved = std::sqrt(2.) * roundings + turning_roundings;
        direction.add(glm::length(glm::dvec3(sample_cone(cone, u)) - exact), moved * eps, u.x, u.y,
                      part, text(to_center));
    }
    INFO("seed " << seed << ", worst at " << angle.input() << " and " << direction.input());
    CHECK(angle.share() <= 1.);
    CHECK(direction.share() <= 1.);
}

TEST_CASE("rays into a sphere light end in front of it and no farther off than its rounding",
          "[pathtracer][twins]") {
    Inputs inputs;
    WorstCase early, late;
    for (int i = 0; i < random_cases; ++i) {
        const glm::vec3 to_center = inputs.magnitude(-3.f, 3.f) * inputs.direction();
        const float radius = inputs.magnitude(-4.f, -.1f) * glm::length(to_center);
        const SphereCone cone = sphere_cone(to_center, radius);
        const glm::vec3 wi = sample_cone(cone, inputs.square());
        const glm::dvec3 w = glm::normalize(glm::dvec3(wi));
        const glm::dvec3 c(to_center);
        const double d = glm::length(c);
        const double along = glm::dot(w, c);
        const double chord2 = double(radius) * double(radius) - (d * d - along * along);
        const double exact = along - std::sqrt(std::max(chord2, 0.));
        const double error = double(distance_to_sphere(cone, radius, wi)) - exact;
        // Half the chord squared is taken larger by 8 roundings of d^2, and rounded by as many;
        // where that is more than the chord itself, the root of it all is what it comes to.
        const double slack = std::sqrt(std::max(chord2, 0.) + 24. * eps * d * d) -
                             std::sqrt(std::max(chord2, 0.)) + 8. * eps * d;
        early.add(std::min(error, 0.), slack, text(to_center), radius, text(wi));
        // Beyond the surface only by the roundings of the distance itself.
        late.add(std::max(error, 0.), 8. * eps * d, text(to_center), radius, text(wi));
    }
    INFO("seed " << seed << ", worst at " << early.input() << " and " << late.input());
    CHECK(early.share() <= 1.);
    CHECK(late.share() <= 1.);
}

TEST_CASE("irradiance of a point light in float is its double twin", "[pathtracer][twins]") {
    Inputs inputs;
    WorstCase worst;
    for (int i = 0; i < random_cases; ++i) {
        const glm::vec3 x = inputs.magnitude(-3.f, 3.f) * inputs.direction();
        const glm::vec3 n = inputs.direction();
        PointLight light;
        light.position = x + inputs.magnitude(-3.f, 3.f) * inputs.direction();
        light.intensity = Spectrum(inputs.magnitude(-20.f, 20.f));
        const glm::dvec3 way = glm::dvec3(light.position) - glm::dvec3(x);
        const double d = glm::length(way);
        if (d == 0.) continue;  // the light is where the point is: no direction, tested elsewhere
        const double I = double(light.intensity.x);
        const double twin = I * std::max(glm::dot(glm::dvec3(n), way), 0.) / (d * d * d);
        // The scalar product of almost perpendicular vectors cancels: four roundings of its terms.
        const double terms = glm::dot(glm::abs(glm::dvec3(n)), glm::abs(way));
        const double bound = eps * (12. * twin + 4. * I * terms / (d * d * d)) + 0x1p-149;
        worst.add(double(sample_point_light(light, x, n).E.x) - twin, bound, text(x), text(n),
                  text(light.position), light.intensity.x);
    }
    INFO("seed " << seed << ", worst at " << worst.input());
    CHECK(worst.share() <= 1.);
}

TEST_CASE("a spot's edge in float is its double twin however sharp", "[pathtracer][twins]") {
    Inputs inputs;
    WorstCase worst;
    for (int i = 0; i < random_cases; ++i) {
        PointLight light;
        light.intensity = Spectrum(1.f);
        const float outer = std::min(inputs.magnitude(-2.f, .19f), 1.5707963f);
        const float inner = outer * (1.f - inputs.magnitude(-5.f, 0.f));
        light.cone = SpotCone{inputs.direction(), inner, outer};
        const glm::vec3 to_light = inputs.magnitude(-3.f, 3.f) * inputs.direction();
        const glm::dvec3 way(to_light);
        const double d = glm::length(way);
        const double cosine = -glm::dot(way, glm::dvec3(light.cone->direction)) / d;
        const double from = std::cos(double(outer)), to = std::cos(double(inner));
        const double ramp = std::clamp((cosine - from) / (to - from), 0., 1.);
        const double twin = ramp * ramp / (d * d);
        // Three cosines, each off by four roundings, over the width of the edge: twice that in the
        // square. An edge no wider than that may fall on either side.
        const double bound = std::min(2. * 12. * eps / (to - from) + 10. * eps, 1.) / (d * d);
        worst.add(double(normal_irradiance(light, to_light).x) - twin, bound, inner, outer,
                  text(light.cone->direction), text(to_light));
    }
    INFO("seed " << seed << ", worst at " << worst.input());
    CHECK(worst.share() <= 1.);
}
