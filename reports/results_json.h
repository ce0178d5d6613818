// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "reports/report.h"

namespace plumbline::reports {

/// Every figure of the report; what is not finite or does not apply is null.
///
/// Keys: version, date, command, quality, machine {cpu, system, threads}, scenes [{scene,
/// description, hash, frame, width, height, truth {command, spp, seconds, rays, relmse_estimate,
/// mean {radiance, indirect, bounce1}, noise_rmse {radiance, indirect}}, models [{id, title, model,
/// command, surfels, set, seconds, frame_ms, notes, figures {...}, errors {radiance, indirect}}],
/// path_tracer [{spp, seconds, rays, errors}], path_tracer_line {slope, equal_error_seconds {id:
/// seconds}}, fit, effects, left_out, animation {first, last, width, height, truth_spp, updates,
/// models [{title, errors [{frame, rmse, bias_mse, mean_ratio}]}]}, frontier and audit as those
/// commands print them, verdict}], transfer and shared_fit as `fit --json` prints
/// them, hard_cases as `stress --json`. Each of
/// errors is what `compare --json` prints, with reference_mean, test_mean and mean_ratio.
nlohmann::ordered_json results_json(const Report& report);

}  // namespace plumbline::reports
