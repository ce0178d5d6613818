// SPDX-License-Identifier: Apache-2.0
#include "reports/stages.h"

#include <fmt/core.h>

#include <cstdio>

#include "reports/words.h"
#include "scenes/progress.h"

namespace plumbline::reports {

Stages::Stages(double total_work) : total_(total_work) {}

void Stages::begin(const std::string& step, double work) {
    done_ += current_;
    current_ = work;
    if (!Progress::visible()) return;
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    const std::string left =
        done_ > 0 ? fmt::format(", about {} left",
                                duration_text(elapsed.count() * (total_ - done_) / done_))
                  : "";
    fmt::print(stderr, "{:3.0f} % of the report{}: {}\n", 100 * done_ / total_, left, step);
}

}  // namespace plumbline::reports
