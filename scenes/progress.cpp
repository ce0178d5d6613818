// SPDX-License-Identifier: Apache-2.0
#include "scenes/progress.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace plumbline {
namespace {

constexpr int bar_width = 30;
constexpr std::int64_t redraw_ms = 200;

std::atomic<bool> silenced = false;

std::string clock_text(double seconds) {
    const auto s = std::llround(seconds);
    return fmt::format("{}:{:02}", s / 60, s % 60);
}

}  // namespace

Progress::Progress(std::string label, std::uint64_t total, std::uint64_t done)
    : label_(std::move(label)),
      total_(std::max<std::uint64_t>(total, 1)),
      done_before_(done),
      visible_(visible()),
      done_(done),
      start_(std::chrono::steady_clock::now()) {}

Progress::~Progress() {
    if (visible_) static_cast<void>(std::fputs("\r\033[K", stderr));
}

void Progress::silence() { silenced = true; }

bool Progress::visible() { return !silenced && ::isatty(STDERR_FILENO) != 0; }

void Progress::advance(std::uint64_t steps) {
    const std::uint64_t done = done_.fetch_add(steps, std::memory_order_relaxed) + steps;
    if (!visible_) return;
    const auto elapsed = std::chrono::steady_clock::now() - start_;
    const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(elapsed).count();
    std::int64_t due = next_draw_ms_.load(std::memory_order_relaxed);
    if (ms < due || !next_draw_ms_.compare_exchange_strong(due, ms + redraw_ms)) return;
    const std::lock_guard lock(drawing_);
    draw(done);
}

void Progress::revise(std::string label, std::uint64_t total) {
    const std::lock_guard lock(drawing_);
    label_ = std::move(label);
    total_ = std::max<std::uint64_t>(total, 1);
}

void Progress::draw(std::uint64_t done) {
    const double part = std::min(1.0, static_cast<double>(done) / static_cast<double>(total_));
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    const auto filled = static_cast<std::size_t>(part * bar_width);
    std::string bar(filled, '#');
    bar.resize(bar_width, '.');
    const double steps = static_cast<double>(done - done_before_);
    const double steps_left = static_cast<double>(total_ - std::min(done, total_));
    const std::string left =
        steps > 0 ? clock_text(elapsed.count() * steps_left / steps) + " left" : "";
    fmt::print(stderr, "\r\033[K{} [{}] {:3.0f} % {}", label_, bar, 100 * part, left);
    static_cast<void>(std::fflush(stderr));
}

}  // namespace plumbline
