// SPDX-License-Identifier: Apache-2.0
#include "reports/embedded_layers.h"

#include <Imath/half.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace plumbline::reports {

namespace {

/// Brings the largest magnitude to [2^14, 2^15), the top of a half's range but one stop.
int exponent_that_fits(std::span<const std::span<const float>> planes) {
    float largest = 0.f;
    for (const std::span<const float> plane : planes)
        for (const float value : plane)
            if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
    if (largest == 0.f) return 0;
    constexpr int top_exponent = 15;
    int exponent = 0;
    std::frexp(largest, &exponent);
    return exponent - top_exponent;
}

/// Differences to the left neighbour, all high bytes before all low ones: most bytes are then near
/// zero or alike, which is what deflate is good at.
std::vector<unsigned char> differences(std::span<const std::span<const float>> planes, int width,
                                       int exponent) {
    std::vector<std::uint16_t> words;
    for (const std::span<const float> plane : planes) {
        std::uint16_t left = 0;
        for (std::size_t i = 0; i < plane.size(); ++i) {
            if (i % static_cast<std::size_t>(width) == 0) left = 0;
            const std::uint16_t bits = half(std::ldexp(plane[i], -exponent)).bits();
            words.push_back(static_cast<std::uint16_t>(bits - left));
            left = bits;
        }
    }
    std::vector<unsigned char> bytes;
    bytes.reserve(2 * words.size());
    for (const std::uint16_t word : words) bytes.push_back(static_cast<unsigned char>(word >> 8));
    for (const std::uint16_t word : words) bytes.push_back(static_cast<unsigned char>(word & 0xff));
    return bytes;
}

std::vector<unsigned char> deflated(const std::vector<unsigned char>& bytes) {
    uLongf size = compressBound(static_cast<uLong>(bytes.size()));
    std::vector<unsigned char> packed(size);
    if (compress2(packed.data(), &size, bytes.data(), static_cast<uLong>(bytes.size()),
                  Z_DEFAULT_COMPRESSION) != Z_OK)
        throw std::runtime_error("zlib could not deflate a layer");
    packed.resize(size);
    return packed;
}

}  // namespace

std::string base64(std::span<const unsigned char> bytes) {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const auto byte = [&](std::size_t k) {
            return k < bytes.size() ? std::uint32_t{bytes[k]} : 0u;
        };
        const std::uint32_t group = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k <= bytes.size() ? digits[group >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

PackedPlanes pack_planes(std::span<const std::span<const float>> planes, int width) {
    const int exponent = exponent_that_fits(planes);
    return {base64(deflated(differences(planes, width, exponent))), exponent};
}

}  // namespace plumbline::reports
