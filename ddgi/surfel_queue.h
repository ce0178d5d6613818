// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "ddgi/surfel_marks.h"

namespace plumbline::ddgi {

/// Surfels that something touched and that wait for their turn, where no more than a budget of them
/// are re-placed or lit again at an update.
///
/// The highest priorities go first: the updates since a surfel was touched, this one included,
/// times the number of things that changed of it (where it is, its light, which probes it sees; one
/// to be placed counts for all three). So all get their turn, and those that changed most wait
/// least. Among equals the order is spread evenly over the rays of all probes, and always the same.
class SurfelQueue {
 public:
    /// `budget`: surfels a turn, at least 1.
    SurfelQueue(std::size_t surfels, int budget);

    /// Adds what is marked to what waits, and leaves in `marks` what is to be done this time.
    void take_turn(SurfelMarks& marks);

    std::uint64_t waiting() const { return waiting_.size(); }
    /// Turns since the oldest of these was touched, that turn included; 0 if none waits.
    int oldest() const;

 private:
    std::uint64_t key_of(std::uint32_t surfel) const;

    std::size_t budget_;
    std::uint32_t turn_ = 0;
    std::vector<std::uint8_t> pending_;  ///< sets of Mark, one a surfel
    std::vector<std::uint32_t> since_;   ///< the turn in which it was touched, of those that wait
    std::vector<std::uint32_t> waiting_;
};

}  // namespace plumbline::ddgi
