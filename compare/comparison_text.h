// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "compare/comparison.h"

namespace plumbline::compare {

/// A comparison as a table for a terminal: each metric with its formula, then noise against bias,
/// then the error by scale. r is the reference and t the test.
std::string to_text(const Comparison& comparison);

}  // namespace plumbline::compare
