// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>
#include <limits>

namespace plumbline {

/// A radiometric quantity or an albedo per linear Rec.709 channel; its name says which.
using Spectrum = glm::vec3;

inline float max_component(const glm::vec3& v) { return glm::max(v.x, glm::max(v.y, v.z)); }
inline float min_component(const glm::vec3& v) { return glm::min(v.x, glm::min(v.y, v.z)); }

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
