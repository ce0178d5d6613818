// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <optional>

namespace plumbline {

/// The rotation that a file's quaternion means, or none if it is not of unit length.
///
/// One that is off by rounding alone is kept bit for bit, so that a scene survives being written
/// and read; one written with a few digits is normalised.
inline std::optional<glm::quat> unit_rotation(const glm::quat& written) {
    constexpr float rounding = 1e-6f;
    constexpr float few_digits = 1e-3f;
    const float off = std::abs(glm::length(written) - 1.f);
    if (off <= rounding) return written;
    if (off <= few_digits) return glm::normalize(written);
    return std::nullopt;
}

}  // namespace plumbline
