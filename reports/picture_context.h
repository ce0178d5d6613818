// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "reports/scene_report.h"

namespace plumbline::reports {

/// The still pictures and error maps of a scene with their scale bars: {exposure, shrunk,
/// pictures, scale_bars}, at 1/`block` of their size.
nlohmann::json picture_context(const SceneReport& report, int block);

}  // namespace plumbline::reports
