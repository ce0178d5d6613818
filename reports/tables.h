// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "reports/scene_report.h"

namespace plumbline::reports {

/// Tables as reports/page/scene.html wants them: {columns: [...], rows: [{title, color, cells:
/// [{text, note, value}]}]}; `value` is what a column sorts by, empty if there is none.

/// Every metric of a layer ("" is radiance), a picture a row, with its time.
nlohmann::json metrics_table(const SceneReport& report, const std::string& layer);

/// What each picture took, with its RMSE (indirect).
nlohmann::json times_table(const SceneReport& report);

/// The fit: {summary, constants: [...], notes: [...]}, or null.
nlohmann::json constants_table(const SceneReport& report);

/// The custom property of style.css that colours a model everywhere on the page.
std::string model_color(std::size_t index);

}  // namespace plumbline::reports
