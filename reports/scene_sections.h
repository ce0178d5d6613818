// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "reports/scene_report.h"
#include "reports/study_section.h"

namespace plumbline::reports {

/// What the report's page shows of a scene beyond its pictures and their metrics: the error by
/// scale, over the animation, against time, and where the models make or lose light. What was not
/// measured is left out.
std::vector<StudySection> scene_sections(const SceneReport& report);

/// The error of each model over the frames.
StudySection animation_section(const AnimationErrors& animation);

/// The flux of each bounce: see compare::EnergyAudit.
StudySection audit_section(const std::vector<compare::EnergyAudit>& audits);

}  // namespace plumbline::reports
