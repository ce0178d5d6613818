// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "compare/fit.h"

namespace plumbline::compare {

/// A fit with the keys that the README lists. The standard error of a constant that cannot be
/// known is infinite, which JSON cannot say: null.
nlohmann::ordered_json to_json(const FitResult& result);

nlohmann::ordered_json to_json(const std::vector<TransferError>& transfer);

/// A fit as a table for a terminal.
std::string to_text(const FitResult& result);

}  // namespace plumbline::compare
