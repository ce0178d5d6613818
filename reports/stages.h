// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <string>

namespace plumbline::reports {

/// Tells on a terminal which step of a long piece of work begins, and how much time is left.
///
/// Work is counted in samples a pixel of the path tracer, or what takes about as long.
class Stages {
 public:
    explicit Stages(double total_work);

    /// Announces a step of this much work; the one before it is then done.
    void begin(const std::string& step, double work);

 private:
    double total_;
    double done_ = 0;
    double current_ = 0;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace plumbline::reports
