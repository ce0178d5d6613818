// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "reports/scene_report.h"

namespace plumbline::reports {

/// The path tracer's error against its time, log e = intercept + slope log t, least squares over
/// its measured pictures. e is the RMSE of the indirect layer with the truth's own noise taken off
/// in quadrature. Samples that are independent make the slope -1/2.
struct PathTracerLine {
    double slope;
    double intercept;
    double least_seconds;  ///< of the pictures it was measured from
    double most_seconds;

    /// How long the path tracer takes to come to an error.
    double seconds_to(double error) const;
    bool extrapolates(double seconds) const {
        return seconds < least_seconds || seconds > most_seconds;
    }
};

/// None with fewer than two pictures whose error exceeds the truth's noise, or if more time did not
/// bring less error.
std::optional<PathTracerLine> path_tracer_line(const SceneReport& report);

/// The RMSE of a picture's indirect layer without the truth's own noise. None if noise explains it.
std::optional<double> error_without_truth_noise(const SceneReport& report, const LayerError& error);

}  // namespace plumbline::reports
