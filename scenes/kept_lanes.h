// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <type_traits>

#include "scenes/lanes.h"

namespace plumbline {

/// Which lanes are kept where the others' places are closed up.
class KeptLanes {
 public:
    /// Lanes of a group are moved together.
    static constexpr std::size_t group_size = 8;

    /// Those of the first `count` whose flag is not 0.
    KeptLanes(std::size_t count, const Lanes<std::int32_t>& flags);

    std::size_t count() const { return count_; }

    /// Puts the kept lanes of `from` side by side into `to`, in their order; `to` may be `from`,
    /// and what is in its other lanes then holds no more.
    template <typename T>
    void close_up(const Lanes<T>& from, Lanes<T>& to) const {
        static_assert(sizeof(T) == sizeof(Word) && std::is_trivially_copyable_v<T>);
        close_up(reinterpret_cast<const Word*>(from.data()), reinterpret_cast<Word*>(to.data()));
    }
    void close_up(const Lanes3& from, Lanes3& to) const {
        close_up(from.x, to.x);
        close_up(from.y, to.y);
        close_up(from.z, to.z);
    }
    template <typename T>
    void close_up(T& lanes) const {
        close_up(lanes, lanes);
    }

 private:
    /// Any value of 32 bits.
    using Word [[gnu::may_alias]] = std::uint32_t;

    void choose(const std::int32_t* flags);
    void close_up(const Word* from, Word* to) const;

    std::size_t count_ = 0;
    std::size_t groups_;
    std::size_t last_group_;                                  ///< lanes of it
    std::array<std::size_t, lane_count / group_size> first_;  ///< where each group's kept lanes go
    Lanes<std::uint32_t> places_;                             ///< in its group, of what goes there
};

}  // namespace plumbline
