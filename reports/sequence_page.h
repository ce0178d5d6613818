// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "reports/sequence.h"
#include "reports/study_page.h"

namespace plumbline::reports {

/// The timing study with the charts of [Dellson 2023, figures 5.10 to 5.25]: each configuration
/// over the frames, all together, and averages, beside the published averages if `scene` has some.
StudyPage sequence_page(const Sequence& sequence, const std::string& scene,
                        const std::string& command);

}  // namespace plumbline::reports
