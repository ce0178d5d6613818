// SPDX-License-Identifier: Apache-2.0
#include "reports/machine.h"

#include <sys/utsname.h>
#include <tbb/global_control.h>
#include <tbb/info.h>

#include <algorithm>
#include <fstream>

namespace plumbline::reports {

namespace {

std::string cpu_name() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        const std::size_t colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos)
            return line.substr(colon + 2);
    }
    return "unknown CPU";
}

}  // namespace

Machine this_machine() {
    utsname names{};
    const bool named = ::uname(&names) == 0;
    const auto limit = static_cast<int>(
        tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
    return {cpu_name(),
            named ? std::string(names.sysname) + " " + names.release + " " + names.machine
                  : "unknown system",
            std::min(limit, tbb::info::default_concurrency())};
}

}  // namespace plumbline::reports
