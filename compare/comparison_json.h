// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "compare/comparison.h"

namespace plumbline::compare {

/// A comparison with the keys that the README lists. Numbers that are infinite (psnr_db of equal
/// images) or undefined are null, and so is "noise" if neither image has variances.
nlohmann::ordered_json to_json(const Comparison& comparison);

}  // namespace plumbline::compare
