// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "reports/output_folder.h"
#include "reports/report.h"

namespace plumbline::reports {

/// The report as Markdown: verdicts, models, constants, their transfer, frontiers, and the commands
/// that make each.
std::string results_markdown(const Report& report);

/// results_markdown() under the name `file`, and a strip of pictures for each scene beside it:
/// results-SCENE.png.
FolderFiles published_files(const Report& report, const std::string& file);

}  // namespace plumbline::reports
