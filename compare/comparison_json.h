// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "compare/comparison.h"

namespace plumbline::compare {

/// Every metric under its name.
nlohmann::ordered_json metrics_json(const Metrics& metrics);

/// Null if nothing is known of the noise.
nlohmann::ordered_json noise_json(const std::optional<NoiseSplit>& noise);

/// A comparison with the keys that the README lists. Numbers that are infinite (psnr_db of equal
/// images) or undefined are null, and so is "noise" if neither image has variances.
nlohmann::ordered_json to_json(const Comparison& comparison);

}  // namespace plumbline::compare
