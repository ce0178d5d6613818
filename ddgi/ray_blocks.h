// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

namespace plumbline::ddgi {

/// How many rays lie side by side in vector registers.
constexpr std::size_t rays_in_block = 8;

/// `Count` values of each ray of all probes, in blocks of rays_in_block rays: a value of these lies
/// side by side, and behind it the next value. So vector registers are filled at once, and all that
/// is known of one ray lies in a few lines of the cache.
template <std::size_t Count>
class RayBlocks {
 public:
    /// `rays` a probe: a multiple of rays_in_block.
    RayBlocks(std::size_t probes, std::size_t rays) : rays_(rays), values_(probes * Count * rays) {}

    std::size_t rays() const { return rays_; }

    float& at(std::size_t probe, std::size_t value, std::size_t ray) {
        return values_[index(probe, value, ray)];
    }
    /// Three values that are a vector, from `first` on.
    void put(std::size_t probe, std::size_t first, std::size_t ray, const glm::vec3& v) {
        at(probe, first, ray) = v.x;
        at(probe, first + 1, ray) = v.y;
        at(probe, first + 2, ray) = v.z;
    }
    /// This value of `ray` and of the others of the block that begins with it, side by side.
    const float* block(std::size_t probe, std::size_t value, std::size_t ray) const {
        return &values_[index(probe, value, ray)];
    }
    /// How much further than value 0 of a probe's first ray a value of its ray `ray` is.
    static std::size_t further(std::size_t ray, std::size_t value) {
        return (ray / rays_in_block * Count + value) * rays_in_block + ray % rays_in_block;
    }

 private:
    std::size_t index(std::size_t probe, std::size_t value, std::size_t ray) const {
        return probe * rays_ * Count + further(ray, value);
    }

    std::size_t rays_;
    std::vector<float> values_;
};

}  // namespace plumbline::ddgi
