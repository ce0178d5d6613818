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

    Sampler(std::uint64_t pixel, int sample)
        : key_(mix_bits(pixel ^ static_cast<std::uint64_t>(sample / batch_size))),
          index_(static_cast<unsigned>(sample % batch_size)) {}

    /// The point of the next pair of dimensions.
    glm::vec2 next_2d() {
        constexpr std::uint64_t golden_ratio = 0x9e3779b97f4a7c15u;  // 2^64 / phi [Steele et al.]
        key_ += golden_ratio;
        const std::uint64_t trees = mix_bits(key_);
        const std::uint64_t low_digits = mix_bits(trees + index_);
        const unsigned i = scrambled(index_, trees);
        const unsigned x = scrambled(nibble(sobol_0, i), trees >> 16);
        const unsigned y = scrambled(nibble(sobol_1, i), trees >> 32);
        return {unit_float(x, low_digits >> 44), unit_float(y, (low_digits >> 12) & 0xfffffu)};
    }

    /// A number of the next pair of dimensions.
    float next_1d() { return next_2d().x; }

 private:
    // The first four binary digits of point i stand in hexadecimal place i, for the first two
    // dimensions of the Sobol sequence [Joe and Kuo 2008]: i reversed, and i times Pascal's
    // triangle modulo 2.
    static constexpr std::uint64_t sobol_0 = 0xf7b3d591e6a2c480u;
    static constexpr std::uint64_t sobol_1 = 0x19d5b37fe62a4c80u;

    static constexpr unsigned nibble(std::uint64_t table, unsigned place) {
        return static_cast<unsigned>(table >> (4 * place)) & 0xfu;
    }

    /// Flips each of four binary digits by the random bit of `tree` that its higher digits choose;
    /// bits 1 to 15 of `tree` are a binary tree in heap order.
    static constexpr unsigned scrambled(unsigned digits, std::uint64_t tree) {
        const unsigned node = digits | 0x10u;
        const auto bits = static_cast<unsigned>(tree & 0xffffu);
        const unsigned flips = ((bits >> (node >> 4)) & 1u) << 3 |
                               ((bits >> (node >> 3)) & 1u) << 2 |
                               ((bits >> (node >> 2)) & 1u) << 1 | ((bits >> (node >> 1)) & 1u);
        return digits ^ flips;
    }

    /// 24 binary digits after the point, all that a float holds: below 1 without rounding.
    static constexpr float unit_float(unsigned upper_4, std::uint64_t lower_20) {
        return static_cast<float>(upper_4 << 20 | static_cast<unsigned>(lower_20)) * 0x1p-24f;
    }

    std::uint64_t key_;
    unsigned index_;
};

}  // namespace plumbline::pathtracer
