// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

// Colour spaces as FLIP uses them, inline: each runs for every pixel at every exposure.

namespace plumbline::compare {

/// Rec.709 luminance of linear sRGB.
inline constexpr glm::vec3 luminance_weights(0.2126f, 0.7152f, 0.0722f);

/// CIE XYZ of linear sRGB with D65 white, with the authors' matrix [Andersson et al. 2020].
inline glm::vec3 xyz_from_linear_rgb(const glm::vec3& rgb) {
    return {(10135552.f * rgb.r + 8788810.f * rgb.g + 4435075.f * rgb.b) / 24577794.f,
            (2613072.f * rgb.r + 8788810.f * rgb.g + 887015.f * rgb.b) / 12288897.f,
            (1425312.f * rgb.r + 8788810.f * rgb.g + 70074185.f * rgb.b) / 73733382.f};
}
inline glm::vec3 linear_rgb_from_xyz(const glm::vec3& xyz) {
    return {3.241003275f * xyz.x - 1.537398934f * xyz.y - 0.498615861f * xyz.z,
            -0.969224334f * xyz.x + 1.875930071f * xyz.y + 0.041554224f * xyz.z,
            0.055639423f * xyz.x - 0.204011202f * xyz.y + 1.057148933f * xyz.z};
}

/// D65 white in XYZ: the row sums of the matrix; and its inverse.
inline constexpr glm::vec3 white(0.950428545f, 1.f, 1.088900371f);
inline constexpr glm::vec3 inverse_white(1.052156925f, 1.f, 0.918357670f);

/// The linear opponent space in which contrast sensitivity is applied: Y in [-16, 100].
inline glm::vec3 ycxcz_from_linear_rgb(const glm::vec3& rgb) {
    const glm::vec3 v = xyz_from_linear_rgb(rgb) * inverse_white;
    return {116.f * v.y - 16.f, 500.f * (v.x - v.y), 200.f * (v.y - v.z)};
}
inline glm::vec3 linear_rgb_from_ycxcz(const glm::vec3& ycxcz) {
    const float y = (ycxcz.x + 16.f) / 116.f;
    return linear_rgb_from_xyz(glm::vec3(y + ycxcz.y / 500.f, y, y - ycxcz.z / 200.f) * white);
}

/// The cube root of a positive, normal number, to 3e-7 of itself: a third of its exponent, then
/// Halley's iteration twice, which takes the first guess's error of 4 % to its cube each time. A
/// call of the library's takes several times as long, three times a pixel and exposure.
inline float cube_root(float t) {
    constexpr std::uint32_t two_thirds_of_bias = 0x2A5137A0;
    float root = std::bit_cast<float>(std::bit_cast<std::uint32_t>(t) / 3 + two_thirds_of_bias);
    for (int step = 0; step < 2; ++step) {
        const float cube = root * root * root;
        root *= (cube + 2.f * t) / (2.f * cube + t);
    }
    return root;
}

/// The cube root of CIELAB with its linear toe.
inline float lab_root(float t) {
    constexpr float delta = 6.f / 29.f;
    return t > delta * delta * delta ? cube_root(t) : t / (3.f * delta * delta) + 4.f / 29.f;
}

/// CIELAB with a* and b* scaled by L*/100: chroma is seen the less the darker it is
/// [Hunt 1952, as used by Andersson et al. 2020].
inline glm::vec3 hunt_lab_from_linear_rgb(const glm::vec3& rgb) {
    const glm::vec3 v = xyz_from_linear_rgb(rgb) * inverse_white;
    const float x = lab_root(v.x), y = lab_root(v.y), z = lab_root(v.z);
    const float L = 116.f * y - 16.f;
    return {L, 0.01f * L * 500.f * (x - y), 0.01f * L * 200.f * (y - z)};
}

/// The distance for large colour differences [Abasi et al. 2020].
inline float hyab(const glm::vec3& a, const glm::vec3& b) {
    const glm::vec3 d = a - b;
    return std::abs(d.x) + std::sqrt(d.y * d.y + d.z * d.z);
}

}  // namespace plumbline::compare
