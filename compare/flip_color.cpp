// SPDX-License-Identifier: Apache-2.0
#include "compare/flip_color.h"

#include <cmath>

namespace plumbline::compare {

namespace {

/// D65 white in XYZ: the row sums of the matrix below.
const glm::vec3 white(0.950428545f, 1.f, 1.088900371f);
const glm::vec3 inverse_white(1.052156925f, 1.f, 0.918357670f);

/// Numerators (c x^2 + d x) and denominators of the curve, in x after the pre-exposure.
constexpr double pre_exposure = 0.6;
constexpr double c2 = pre_exposure * pre_exposure * 2.51, c1 = pre_exposure * 0.03;
constexpr double d2 = pre_exposure * pre_exposure * 2.43, d1 = pre_exposure * 0.59, d0 = 0.14;

/// The cube root of CIELAB with its linear toe [CIE 15].
float lab_f(float t) {
    constexpr float delta = 6.f / 29.f;
    return t > delta * delta * delta ? std::cbrt(t) : t / (3.f * delta * delta) + 4.f / 29.f;
}

}  // namespace

glm::vec3 xyz_from_linear_rgb(const glm::vec3& rgb) {
    return {(10135552.f * rgb.r + 8788810.f * rgb.g + 4435075.f * rgb.b) / 24577794.f,
            (2613072.f * rgb.r + 8788810.f * rgb.g + 887015.f * rgb.b) / 12288897.f,
            (1425312.f * rgb.r + 8788810.f * rgb.g + 70074185.f * rgb.b) / 73733382.f};
}

glm::vec3 linear_rgb_from_xyz(const glm::vec3& xyz) {
    return {3.241003275f * xyz.x - 1.537398934f * xyz.y - 0.498615861f * xyz.z,
            -0.969224334f * xyz.x + 1.875930071f * xyz.y + 0.041554224f * xyz.z,
            0.055639423f * xyz.x - 0.204011202f * xyz.y + 1.057148933f * xyz.z};
}

glm::vec3 ycxcz_from_linear_rgb(const glm::vec3& rgb) {
    const glm::vec3 v = xyz_from_linear_rgb(rgb) * inverse_white;
    return {116.f * v.y - 16.f, 500.f * (v.x - v.y), 200.f * (v.y - v.z)};
}

glm::vec3 linear_rgb_from_ycxcz(const glm::vec3& ycxcz) {
    const float y = (ycxcz.x + 16.f) / 116.f;
    return linear_rgb_from_xyz(glm::vec3(y + ycxcz.y / 500.f, y, y - ycxcz.z / 200.f) * white);
}

glm::vec3 hunt_lab_from_linear_rgb(const glm::vec3& rgb) {
    const glm::vec3 v = xyz_from_linear_rgb(rgb) * inverse_white;
    const float x = lab_f(v.x), y = lab_f(v.y), z = lab_f(v.z);
    const float L = 116.f * y - 16.f;
    return {L, 0.01f * L * 500.f * (x - y), 0.01f * L * 200.f * (y - z)};
}

float hyab(const glm::vec3& a, const glm::vec3& b) {
    const glm::vec3 d = a - b;
    return std::abs(d.x) + std::sqrt(d.y * d.y + d.z * d.z);
}

float tone_map_aces(float x) {
    constexpr float n2 = float(c2), n1 = float(c1), m2 = float(d2), m1 = float(d1), m0 = float(d0);
    // Divided by x^2 beyond 1, lest very bright pixels become infinity over infinity.
    if (std::abs(x) > 1.f) return (n2 + n1 / x) / (m2 + m1 / x + m0 / x / x);
    return (n2 * x * x + n1 * x) / (m2 * x * x + m1 * x + m0);
}

double inverse_tone_map_aces(double y) {
    // The positive root of (c2 - y d2) x^2 + (c1 - y d1) x - y d0 = 0.
    const double a = c2 - y * d2, half_b = 0.5 * (c1 - y * d1), c = -y * d0;
    return (-half_b + std::sqrt(half_b * half_b - a * c)) / a;
}

}  // namespace plumbline::compare
