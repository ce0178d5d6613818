// SPDX-License-Identifier: Apache-2.0
#include "reports/equal_error.h"

#include <cmath>

#include "reports/layer_statistics.h"

namespace plumbline::reports {

double PathTracerLine::seconds_to(double error) const {
    return std::exp((std::log(error) - intercept) / slope);
}

std::optional<double> error_without_truth_noise(const SceneReport& report,
                                                const LayerError& error) {
    const double noise = layer_noise(report.truth.image, "indirect");
    const double rest = error.mse() - noise * noise;
    if (!(rest > 0)) return {};
    return std::sqrt(rest);
}

std::optional<PathTracerLine> path_tracer_line(const SceneReport& report) {
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    PathTracerLine line{0, 0, HUGE_VAL, 0};
    for (const PathTracerRun& run : report.path_tracer) {
        const std::optional<double> error = error_without_truth_noise(report, run.errors.indirect);
        if (!error || !(run.seconds > 0)) continue;
        const double x = std::log(run.seconds);
        const double y = std::log(*error);
        n += 1;
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
        line.least_seconds = std::min(line.least_seconds, run.seconds);
        line.most_seconds = std::max(line.most_seconds, run.seconds);
    }
    const double spread = n * sxx - sx * sx;
    if (n < 2 || !(spread > 0)) return {};
    line.slope = (n * sxy - sx * sy) / spread;
    line.intercept = (sy - line.slope * sx) / n;
    if (!(line.slope < 0)) return {};
    return line;
}

}  // namespace plumbline::reports
