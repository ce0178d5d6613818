// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>

namespace plumbline {

/// A progress bar with time left on a terminal's stderr; nothing when piped or silenced.
class Progress {
 public:
    /// `total` steps, of which `done` were taken before, at a speed that tells nothing of this one.
    Progress(std::string label, std::uint64_t total, std::uint64_t done = 0);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Counts work done; thread-safe. Draws a few times a second.
    void advance(std::uint64_t steps = 1);

    /// Shows another label, and counts on towards another total.
    void revise(std::string label, std::uint64_t total);

    /// Silences every bar of this process (--quiet).
    static void silence();
    /// True on a terminal that nobody silenced.
    static bool visible();

 private:
    void draw(std::uint64_t done);

    std::string label_;
    std::uint64_t total_;
    std::uint64_t done_before_;
    bool visible_;
    std::atomic<std::uint64_t> done_;
    std::chrono::steady_clock::time_point start_;
    std::atomic<std::int64_t> next_draw_ms_{0};
    std::mutex drawing_;
};

}  // namespace plumbline
