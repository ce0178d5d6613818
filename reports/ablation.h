// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "compare/metrics.h"
#include "compare/noise.h"
#include "reports/ablation_cases.h"
#include "scenes/image.h"
#include "scenes/scene.h"

namespace plumbline::reports {

/// What one case reached on one scene, converged, and what it cost.
struct AblationRow {
    AblationCase subject;
    double mean_ratio;         ///< of the indirect layer to the truth's
    compare::Metrics metrics;  ///< of the indirect layer
    compare::NoiseSplit noise;
    double best_gain;           ///< that would leave the least squared error
    double rmse_with_gain;      ///< ... and what it would leave
    double place_ms, light_ms;  ///< of all surfels
    double update_ms;           ///< mean of a probe update
    double primary_ms;
    double bytes;  ///< that probes and surfels hold
    int updates;
    bool converged;
    std::uint64_t non_finite;
    std::uint64_t surfels_hit;  ///< of all probes
    std::uint64_t surfels_lit;  ///< those of them that light is measured at
    std::uint64_t shadow_rays;  ///< to light these
};

struct AblationScene {
    std::string name;
    int frame;
    int width, height;
    std::vector<AblationRow> rows;
};

/// Runs every case on a scene's still and holds its indirect layer against `truth`, a picture of
/// the same size with variances. Throws UsageError, ImageError.
AblationScene measure_ablation(const Scene& scene, int frame, const Image& truth,
                               const std::vector<AblationCase>& cases);

}  // namespace plumbline::reports
