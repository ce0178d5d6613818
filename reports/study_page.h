// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/study_section.h"

namespace plumbline::reports {

/// What a study found.
struct StudyPage {
    std::string title;
    std::string command;            ///< makes the same page
    std::vector<std::string> lead;  ///< paragraphs that say what was found, and how it was measured
    std::vector<StudySection> sections;
};

/// The study as one HTML file that opens offline and asks the network for nothing. All text is
/// escaped. Values that are not finite are left out of charts.
std::string study_html(const StudyPage& page);

}  // namespace plumbline::reports
