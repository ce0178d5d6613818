// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace plumbline::reports {

/// What times depend on.
struct Machine {
    std::string cpu;     ///< as /proc/cpuinfo names it; "unknown CPU" elsewhere
    std::string system;  ///< kernel, release and architecture
    int threads;         ///< that oneTBB uses
};

Machine this_machine();

}  // namespace plumbline::reports
