// SPDX-License-Identifier: Apache-2.0
// Stands in for TBB's header where ThreadSanitizer looks for races: it does not see how a TBB that
// is not compiled with it hands work from thread to thread, and would report every loop. These
// loops run on plain threads, whose start and end it knows, so that any race between two rounds
// shows.
#pragma once

#include <tbb/blocked_range.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <thread>
#include <vector>

namespace tbb {

/// Calls body(i) for first <= i < last on four threads; the first exception goes on to the caller.
template <typename Index, typename Body>
void parallel_for(Index first, Index last, const Body& body) {
    // Relaxed: taking a round orders nothing, so that it hides no race.
    std::atomic<Index> next{first};
    std::exception_ptr failures[4];
    const auto work = [&](std::exception_ptr& failure) {
        try {
            for (Index i = next.fetch_add(1, std::memory_order_relaxed); i < last;
                 i = next.fetch_add(1, std::memory_order_relaxed)) {
                body(i);
            }
        } catch (...) {
            failure = std::current_exception();
        }
    };
    std::vector<std::thread> threads;
    for (std::exception_ptr& failure : failures) threads.emplace_back(work, std::ref(failure));
    for (std::thread& thread : threads) thread.join();
    for (const std::exception_ptr& failure : failures) {
        if (failure) std::rethrow_exception(failure);
    }
}

template <typename Body>
void parallel_for(const blocked_range<std::size_t>& range, const Body& body) {
    const std::size_t step = std::max<std::size_t>(1, range.size() / 16);
    parallel_for(std::size_t{0}, (range.size() + step - 1) / step, [&](std::size_t i) {
        const std::size_t begin = range.begin() + i * step;
        body(blocked_range<std::size_t>(begin, std::min(begin + step, range.end())));
    });
}

}  // namespace tbb
