// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "compare/metrics.h"

namespace plumbline::compare {

/// A metric must not be above a value.
struct Threshold {
    MetricDescription metric;
    double limit;
};

/// Reads "relmse=0.01". Throws UsageError that lists the metrics if there is none of this name, or
/// if the value is not a number.
Threshold parse_threshold(const std::string& text);

/// One line for each threshold that is exceeded: which, and by how much. An undefined metric
/// exceeds every limit, since nothing shows that it does not.
std::vector<std::string> exceeded(const std::vector<Threshold>& thresholds, const Metrics& metrics);

}  // namespace plumbline::compare
