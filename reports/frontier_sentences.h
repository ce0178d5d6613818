// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/frontier.h"

namespace plumbline::reports {

/// What a reader wants to know of a frontier, a sentence or two each: how the path tracer's error
/// falls, what each model's least error is and how long the path tracer takes to it, what a tenth
/// less error costs, and which method is best at which budget.
std::vector<std::string> frontier_sentences(const Frontier& frontier);

}  // namespace plumbline::reports
