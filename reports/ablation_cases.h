// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "ddgi/render.h"

namespace plumbline::reports {

/// A way to run the probes that the ablation measures.
struct AblationCase {
    std::string group;    ///< cases of one group are compared with each other
    std::string name;     ///< unique: letters, digits and dashes
    std::string title;    ///< for readers
    std::string options;  ///< of `plumbline ddgi`, to run the same
    ddgi::DdgiOptions ddgi;
};

/// Every case, in the order of the table: the road from the thesis to conserving, each of its steps
/// alone, each choice of the default model changed alone, and the peer with each of its biases.
std::vector<AblationCase> ablation_cases();

/// Those of them that `names` name, in the order of the table. Throws UsageError for a name that is
/// not there.
std::vector<AblationCase> ablation_cases(const std::vector<std::string>& names);

/// Every model and every way to weight its probes: those that may leak light in unlike ways.
std::vector<AblationCase> leak_cases();

}  // namespace plumbline::reports
