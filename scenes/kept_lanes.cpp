// SPDX-License-Identifier: Apache-2.0
#include "scenes/kept_lanes.h"

#include <bit>

#include "scenes/wide.h"

namespace plumbline {
namespace {

constexpr std::size_t group_size = KeptLanes::group_size;
constexpr std::size_t choices = std::size_t{1} << group_size;
using Group [[gnu::vector_size(32)]] = std::uint32_t;

/// For every choice of a group's lanes the places of those chosen, in order, four binary digits
/// each from the lowest on; then any.
constexpr auto places_of = [] {
    std::array<std::uint32_t, choices> places{};
    for (unsigned chosen = 0; chosen < choices; ++chosen) {
        unsigned next = 0;
        for (unsigned lane = 0; lane < group_size; ++lane) {
            if (((chosen >> lane) & 1u) != 0) places[chosen] |= lane << (4 * next++);
        }
    }
    return places;
}();

}  // namespace

KeptLanes::KeptLanes(std::size_t count, const Lanes<std::int32_t>& flags)
    : groups_((count + group_size - 1) / group_size),
      last_group_(count - (groups_ - 1) * group_size) {
    choose(flags.data());
}

PLUMBLINE_WIDE void KeptLanes::choose(const std::int32_t* flags) {
    for (std::size_t group = 0; group < groups_; ++group) {
        Group flag;
        __builtin_memcpy(&flag, flags + group * group_size, sizeof flag);
        Group bits = (flag != 0) & Group{1, 2, 4, 8, 16, 32, 64, 128};
        bits |= __builtin_shufflevector(bits, bits, 4, 5, 6, 7, 0, 1, 2, 3);
        bits |= __builtin_shufflevector(bits, bits, 2, 3, 0, 1, 6, 7, 4, 5);
        bits |= __builtin_shufflevector(bits, bits, 1, 0, 3, 2, 5, 4, 7, 6);
        const bool cut = group + 1 == groups_;
        const std::uint32_t kept = bits[0] & (cut ? (1u << last_group_) - 1u : ~0u);
        const Group places = places_of[kept] >> Group{0, 4, 8, 12, 16, 20, 24, 28};
        __builtin_memcpy(places_.data() + group * group_size, &places, sizeof places);
        first_[group] = count_;
        count_ += static_cast<std::size_t>(std::popcount(kept));
    }
}

PLUMBLINE_WIDE void KeptLanes::close_up(const Word* from, Word* to) const {
    for (std::size_t group = 0; group < groups_; ++group) {
        // Whole groups are written: none ends behind the one that it was read from.
        Group values, places;
        __builtin_memcpy(&values, from + group * group_size, sizeof values);
        __builtin_memcpy(&places, places_.data() + group * group_size, sizeof places);
#if defined(__clang__)
        Group closed;
        for (std::size_t i = 0; i < group_size; ++i) closed[i] = values[places[i] % group_size];
        values = closed;
#else
        values = __builtin_shuffle(values, places);  // takes places modulo the group's size
#endif
        __builtin_memcpy(to + first_[group], &values, sizeof values);
    }
}

}  // namespace plumbline
