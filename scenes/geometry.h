// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>

namespace plumbline {

/// A radiometric quantity or an albedo per linear Rec.709 channel; its name says which.
using Spectrum = glm::vec3;

inline float max_component(const glm::vec3& v) { return glm::max(v.x, glm::max(v.y, v.z)); }
inline float min_component(const glm::vec3& v) { return glm::min(v.x, glm::min(v.y, v.z)); }

/// `v` times a power of two, which rounds nothing, so that its largest component is 1 to 2 (or less
/// if it was no normal number). Squares and products of such vectors are in a float's range, where
/// those of vectors shorter than 1e-19 or longer than 1e19 are not.
inline glm::vec3 near_unit_length(const glm::vec3& v) {
    constexpr std::uint32_t exponent_bits = 0x7f800000;
    constexpr std::uint32_t inverse_of = 254u << 23;            // 2^e in its bits is 2^-e
    constexpr std::uint32_t largest_with_inverse = 253u << 23;  // of which that is no zero
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(max_component(glm::abs(v)));
    const std::uint32_t exponent = std::min(bits & exponent_bits, largest_with_inverse);
    return v * std::bit_cast<float>(inverse_of - exponent);
}

/// `v` at unit length, to the bit as glm::normalize gives it, but of any length; that squares it.
/// Normals of triangles with sides below 1e-9 or above 1e9 are too short or long for that.
inline glm::vec3 unit_length(const glm::vec3& v) { return glm::normalize(near_unit_length(v)); }

/// A ray o + t d with 0 < t < t_max; `direction` has unit length unless a function says otherwise.
struct Ray {
    glm::vec3 origin;
    glm::vec3 direction;
    float t_max = std::numeric_limits<float>::infinity();
};

/// The straight way from `a` to `b`.
struct Segment {
    glm::vec3 a;
    glm::vec3 b;
};

/// An axis-aligned box in world space; empty (containing no point) until extended.
struct Bounds {
    glm::vec3 lower{std::numeric_limits<float>::infinity()};
    glm::vec3 upper{-std::numeric_limits<float>::infinity()};

    bool empty() const { return lower.x > upper.x; }
    bool contains(const glm::vec3& p) const {
        return glm::all(glm::lessThanEqual(lower, p)) && glm::all(glm::lessThanEqual(p, upper));
    }
    void extend(const glm::vec3& p) {
        lower = glm::min(lower, p);
        upper = glm::max(upper, p);
    }
    void extend(const Bounds& other) {
        lower = glm::min(lower, other.lower);
        upper = glm::max(upper, other.upper);
    }
    /// This box with `margin` added on every side.
    Bounds grown(float margin) const { return {lower - margin, upper + margin}; }
    glm::vec3 size() const { return upper - lower; }
    bool operator==(const Bounds&) const = default;
};

}  // namespace plumbline
