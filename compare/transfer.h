// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "compare/fit.h"
#include "compare/observations.h"

namespace plumbline::compare {

/// Fits the constants of `settings` to each case alone, and tests them on every case and on
/// settings.tests. Constants go over as unit_factors() says.
/// Throws as fit() does.
std::vector<TransferError> transfer_errors(const std::vector<FitCase>& cases,
                                           const FitSettings& settings);

/// The same where `observations` are at hand, what `cases` showed.
std::vector<TransferError> transfer_errors(const std::vector<FitCase>& cases,
                                           std::span<const Observations> observations,
                                           const FitSettings& settings);

}  // namespace plumbline::compare
