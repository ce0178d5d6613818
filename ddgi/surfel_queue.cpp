// SPDX-License-Identifier: Apache-2.0
#include "ddgi/surfel_queue.h"

#include <algorithm>
#include <bit>

namespace plumbline::ddgi {
namespace {

/// 2^32 over the golden ratio, made odd: multiples of it, modulo 2^32, are all different, and those
/// of neighbours far apart [Roberts 2018].
constexpr std::uint32_t golden = 0x9e3779b9u;

}  // namespace

SurfelQueue::SurfelQueue(std::size_t surfels, int budget)
    : budget_(static_cast<std::size_t>(budget)), pending_(surfels), since_(surfels) {}

/// Larger ones first; no two are the same.
std::uint64_t SurfelQueue::key_of(std::uint32_t surfel) const {
    const std::uint64_t age = turn_ - since_[surfel] + 1;
    const auto changes = static_cast<std::uint64_t>(std::popcount(pending_[surfel]));
    return (age * changes) << 32 | surfel * golden;
}

void SurfelQueue::take_turn(SurfelMarks& marks) {
    ++turn_;
    for (std::size_t probe = 0; probe < marks.probes(); ++probe) {
        if (marks.of_probe(probe) == 0) continue;
        const std::size_t first = probe * marks.per_probe();
        for (std::size_t i = first; i < first + marks.per_probe(); ++i) {
            if (marks.of(i) == 0) continue;
            if (pending_[i] == 0) {
                waiting_.push_back(static_cast<std::uint32_t>(i));
                since_[i] = turn_;
            }
            pending_[i] |= marks.of(i);
        }
    }
    marks.clear();
    const std::size_t served = std::min(budget_, waiting_.size());
    const auto last = waiting_.begin() + static_cast<std::ptrdiff_t>(served);
    if (last != waiting_.end()) {
        std::ranges::nth_element(waiting_, last, std::ranges::greater(),
                                 [&](std::uint32_t surfel) { return key_of(surfel); });
    }
    for (auto surfel = waiting_.begin(); surfel != last; ++surfel) {
        marks.add(*surfel, pending_[*surfel]);
        pending_[*surfel] = 0;
    }
    waiting_.erase(waiting_.begin(), last);
}

int SurfelQueue::oldest() const {
    if (waiting_.empty()) return 0;
    std::uint32_t first = turn_;
    for (const std::uint32_t surfel : waiting_) first = std::min(first, since_[surfel]);
    return static_cast<int>(turn_ - first + 1);
}

}  // namespace plumbline::ddgi
