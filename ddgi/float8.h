// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <glm/vec4.hpp>

namespace plumbline::ddgi {

constexpr std::size_t float8_lanes = 8;

/// Eight floats in vector registers, however wide those of the machine are: element i of a result
/// depends on elements i alone, so that every bit is the same on all of them.
using Float8 [[gnu::vector_size(float8_lanes * sizeof(float))]] = float;
/// All bits of a lane, or none.
using Mask8 [[gnu::vector_size(sizeof(Float8))]] = std::int32_t;
/// Four, as all machines have them.
using Float4 [[gnu::vector_size(4 * sizeof(float))]] = float;

// Inlined always: called, they would pass registers that the caller's machine may not have.

[[gnu::always_inline]] inline Float8 load_float8(const float* from) {
    Float8 lanes;
    std::memcpy(&lanes, from, sizeof lanes);
    return lanes;
}

[[gnu::always_inline]] inline Float4 load_float4(const glm::vec4& from) {
    Float4 four;
    std::memcpy(&four, &from, sizeof four);
    return four;
}

[[gnu::always_inline]] inline Float8 same_float8(float value) { return value - Float8{}; }

[[gnu::always_inline]] inline Float8 smaller(const Float8& a, const Float8& b) {
    return b < a ? b : a;
}

[[gnu::always_inline]] inline Float8 larger(const Float8& a, const Float8& b) {
    return a < b ? b : a;
}

[[gnu::always_inline]] inline Float8 square_root(const Float8& a) {
    Float8 roots;
    for (std::size_t i = 0; i < float8_lanes; ++i) roots[i] = std::sqrt(a[i]);
    return roots;
}

/// Bit i is set if lane i is.
[[gnu::always_inline]] inline std::uint8_t bits_of(const Mask8& mask) {
    unsigned bits = 0;
    for (unsigned i = 0; i < float8_lanes; ++i) bits |= static_cast<unsigned>(mask[i]) & 1u << i;
    return static_cast<std::uint8_t>(bits);
}

/// The lanes added up, always in this order.
[[gnu::always_inline]] inline float sum_of(const Float8& a) {
    float sum = 0.f;
    for (std::size_t i = 0; i < float8_lanes; ++i) sum += a[i];
    return sum;
}

}  // namespace plumbline::ddgi
