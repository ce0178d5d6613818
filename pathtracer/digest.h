// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>
#include <type_traits>

#include "pathtracer/sampler.h"

namespace plumbline::pathtracer {

/// 64 bits that tell contents apart, against mistakes and damage, not against forgery.
class Digest {
 public:
    template <typename T>
    void add(std::span<const T> values) {
        static_assert(std::is_trivially_copyable_v<T>);
        add_bytes(reinterpret_cast<const char*>(values.data()), values.size_bytes());
    }
    void add(std::string_view text) { add_bytes(text.data(), text.size()); }

    std::uint64_t value() const { return state_; }

 private:
    void add_bytes(const char* bytes, std::size_t count) {
        mix(count);  // where one content ends and the next begins counts too
        for (std::size_t i = 0; i < count; i += sizeof(std::uint64_t)) {
            std::uint64_t word = 0;
            std::memcpy(&word, bytes + i, std::min(sizeof word, count - i));
            mix(word);
        }
    }
    void mix(std::uint64_t word) { state_ = mix_bits(state_ + 1 + mix_bits(word)); }

    std::uint64_t state_ = 0;
};

}  // namespace plumbline::pathtracer
