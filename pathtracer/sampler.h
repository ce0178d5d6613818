// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace plumbline::pathtracer {

/// A bijective mix of 64 bits in which every input bit moves every output bit: the finaliser of
/// SplitMix64 [Steele et al. 2014].
constexpr std::uint64_t mix_bits(std::uint64_t v) {
    v = (v ^ (v >> 30)) * 0xbf58476d1ce4e5b9u;
    v = (v ^ (v >> 27)) * 0x94d049bb133111ebu;
    return v ^ (v >> 31);
}

/// The mixes pcg3d and pcg2d of [Jarzynski and Olano 2020]: in 32 bits, of which vector registers
/// multiply eight at a time.
constexpr glm::uvec3 mix_3d(glm::uvec3 v) {
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> 16u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    return v;
}
constexpr glm::uvec2 mix_2d(glm::uvec2 v) {
    v = v * 1664525u + 1013904223u;
    v.x += v.y * 1664525u;
    v.y += v.x * 1664525u;
    v ^= v >> 16u;
    v.x += v.y * 1664525u;
    v.y += v.x * 1664525u;
    return v ^ v >> 16u;
}

/// The key that gives pixel (x, y) random numbers of its own under `seed`.
constexpr std::uint64_t pixel_key(std::uint64_t seed, int x, int y) {
    const auto position = (static_cast<std::uint64_t>(static_cast<std::uint32_t>(y)) << 32) |
                          static_cast<std::uint32_t>(x);
    return mix_bits(mix_bits(seed + 1) + position);
}

/// Points of [0,1)^2 for one sample of a pixel: a pure function of (seed, pixel, sample index).
///
/// Samples come in batches of 16. In each batch, each pair of dimensions is the first 16 points of
/// the Sobol sequence, a (0,4,2)-net in base 2, under a random Owen scrambling, its order shuffled
/// by another so that pairs are independent (padding) [Burley 2020, "Practical Hash-based Owen
/// Scrambling"]. Batches, pairs and pixels are scrambled independently of each other: hence batch
/// means are independent and identically distributed, and their spread tells the variance of the
/// mean without bias.
///
/// With 16 points, a scrambling is 15 random bits for the upper four binary digits; no two points
/// share these, so that all lower digits are plain random bits. This is Owen's scrambling itself,
/// where the hash of [Burley 2020] comes near it.
class Sampler {
 public:
    static constexpr int batch_size = 16;

    /// All that it is; for places where many stand side by side.
    struct State {
        std::uint32_t key_0, key_1;  ///< of the pixel's batch
        std::uint32_t place;         ///< 16 times the pairs drawn, plus the index in the batch
    };

    Sampler(std::uint64_t pixel, int sample) {
        const std::uint64_t key = mix_bits(pixel ^ static_cast<std::uint64_t>(sample / batch_size));
        state_ = {static_cast<std::uint32_t>(key), static_cast<std::uint32_t>(key >> 32),
                  static_cast<std::uint32_t>(sample % batch_size)};
    }
    explicit Sampler(const State& state) : state_(state) {}
    const State& state() const { return state_; }

    /// The point of the next pair of dimensions.
    glm::vec2 next_2d() {
        state_.place += batch_size;
        const std::uint32_t index = state_.place % batch_size;
        const glm::uvec3 trees =
            mix_3d({state_.key_0, state_.key_1, state_.place / batch_size}) >> 16u;
        const glm::uvec2 low_digits = mix_2d({trees.x + index, trees.y}) >> 12u;
        const std::uint32_t i = scrambled(index, trees.x);
        const std::uint32_t x = scrambled(nibble(sobol_0, i), trees.y);
        const std::uint32_t y = scrambled(nibble(sobol_1, i), trees.z);
        return {unit_float(x, low_digits.x), unit_float(y, low_digits.y)};
    }

    /// A number of the next pair of dimensions.
    float next_1d() { return next_2d().x; }

 private:
    // The first four binary digits of point i stand in hexadecimal place i, for the first two
    // dimensions of the Sobol sequence [Joe and Kuo 2008]: i reversed, and i times Pascal's
    // triangle modulo 2.
    static constexpr std::uint64_t sobol_0 = 0xf7b3d591e6a2c480u;
    static constexpr std::uint64_t sobol_1 = 0x19d5b37fe62a4c80u;

    static constexpr std::uint32_t nibble(std::uint64_t table, std::uint32_t place) {
        // In halves of 32 bits, as wide as everything else here: twice as many fit a register.
        const auto half = static_cast<std::uint32_t>(place < 8 ? table : table >> 32);
        return half >> (4u * (place % 8u)) & 0xfu;
    }

    /// Flips each of four binary digits by the random bit of `tree` that its higher digits choose;
    /// bits 1 to 15 of `tree` are a binary tree in heap order.
    static constexpr std::uint32_t scrambled(std::uint32_t digits, std::uint32_t tree) {
        const std::uint32_t node = digits | 0x10u;
        const std::uint32_t flips =
            ((tree >> (node >> 4)) & 1u) << 3 | ((tree >> (node >> 3)) & 1u) << 2 |
            ((tree >> (node >> 2)) & 1u) << 1 | ((tree >> (node >> 1)) & 1u);
        return digits ^ flips;
    }

    /// 24 binary digits after the point, all that a float holds: below 1 without rounding.
    static constexpr float unit_float(std::uint32_t upper_4, std::uint32_t lower_20) {
        return static_cast<float>(static_cast<std::int32_t>(upper_4 << 20 | lower_20)) * 0x1p-24f;
    }

    State state_;
};

}  // namespace plumbline::pathtracer
