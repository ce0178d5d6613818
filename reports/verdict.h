// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/scene_report.h"

namespace plumbline::reports {

/// What a report says of a scene in plain words; accuracy stands beside its time in each sentence.
struct Verdict {
    const ModelRun* best;  ///< least RMSE of the indirect layer; none if no model was run
    std::string headline;
    std::vector<std::string> sentences;

    /// The headline and the sentences.
    std::vector<std::string> all() const;
};

/// `best` points into `report`.
Verdict verdict_of(const SceneReport& report);

}  // namespace plumbline::reports
