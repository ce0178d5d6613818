// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstring>
#include <span>

#include "scenes/image.h"

namespace plumbline::pathtracer::test {

inline bool same_bits(std::span<const float> a, std::span<const float> b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

/// All channels of both have the same bits.
inline bool same_pixels(const Image& a, const Image& b) {
    if (a.channel_names() != b.channel_names()) return false;
    for (const std::string& name : a.channel_names()) {
        if (!same_bits(a.channel(name), b.channel(name))) return false;
    }
    return true;
}

}  // namespace plumbline::pathtracer::test
