// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace plumbline::reports {

/// A file of reports/page/, or chart.min.js, as the build put it into the binary.
std::string_view page_file(std::string_view name);

/// The style sheets, joined.
std::string page_style();

}  // namespace plumbline::reports
