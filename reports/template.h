// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace plumbline::reports {

/// The template reports/page/`name` (Mustache) filled with `context`. Its text is escaped unless
/// the template says otherwise; numbers must have become text before. Each of `partials` is a file
/// of reports/page/ that the template includes by its name without ".html".
/// Throws std::runtime_error if the template is broken.
std::string fill_template(const std::string& name, const nlohmann::json& context,
                          const std::vector<std::string>& partials = {});

}  // namespace plumbline::reports
