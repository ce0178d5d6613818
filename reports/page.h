// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "reports/report.h"

namespace plumbline::reports {

/// The report as one HTML file that opens offline and asks the network for nothing. Everything that
/// comes from scenes is escaped. Pictures are shown at a whole fraction of their size if the page
/// would else exceed `largest` bytes; it then says so.
std::string page_html(const Report& report, std::size_t largest = 20'000'000);

}  // namespace plumbline::reports
