// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "compare/error_maps.h"
#include "reports/scene_report.h"

namespace plumbline::reports {

/// The layer that error maps are of: what the models are about.
inline constexpr const char* map_layer = "indirect";

/// The end of the scale of all error maps of a layer, so that they can be held against each other:
/// the largest limit that compare::error_maps() would take for one model alone.
double error_range(const SceneReport& report, const std::string& layer);

/// The signed and the absolute error map of a model's map_layer.
std::vector<compare::ErrorMap> shown_error_maps(const SceneReport& report, const ModelRun& run);

/// The map in its colours, as RGB bytes, each pixel the mean of a block of `block` x `block`.
std::vector<unsigned char> map_bytes(const compare::ErrorMap& map, int block);

/// A colour map from its lower to its upper end: 256 times R, G, B.
std::vector<unsigned char> color_table(compare::ColorMap colors);

}  // namespace plumbline::reports
