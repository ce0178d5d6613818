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
    Progress(std::string label, std::uint64_t total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Counts work done; thread-safe. Draws a few times a second.
    void advance(std::uint64_t steps = 1);

    /// Silences every bar of this process (--quiet).
    static void silence();
    /// True on a terminal that nobody silenced.
    static bool visible();

 private:
    void draw(std::uint64_t done);

    std::string label_;
    std::uint64_t total_;
    bool visible_;
    std::atomic<std::uint64_t> done_{0};
    std::chrono::steady_clock::time_point start_;
    std::atomic<std::int64_t> next_draw_ms_{0};
    std::mutex drawing_;
};

}  // namespace plumbline
