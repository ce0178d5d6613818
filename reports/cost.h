// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "reports/power_law.h"
#include "scenes/scene.h"

namespace plumbline::reports {

/// What probes of one spacing with so many surfels cost, with every surfel placed.
struct CostPoint {
    float spacing;
    int per_probe;
    std::uint64_t probes;
    double place_ms;   ///< tracing all surfel rays
    double light_ms;   ///< lighting all surfels
    double update_ms;  ///< one update of the probes from last frame's
    double bytes;      ///< that the probes and their surfels hold

    double total_ms() const { return place_ms + light_ms + update_ms; }
};

/// One line of study: cost while one thing varies, as power laws of it.
struct CostSweep {
    std::string varied;  ///< probes or surfels
    std::vector<CostPoint> points;
    std::optional<PowerLaw> place, update, total, bytes;
};

struct CostStudy {
    std::string model;
    int repeats;
    CostSweep probes;   ///< over spacings, at 64 surfels a probe
    CostSweep surfels;  ///< over surfels a probe, at the scene's spacing
};

struct CostOptions {
    std::string model = "conserving";
    std::vector<float> spacings{40.f, 20.f, 40.f / 3.f, 10.f, 8.f, 5.f};
    std::vector<int> surfels{64, 96, 128, 160};
    int repeats = 3;
};

/// Measures frame 0; each time is the least of `repeats`, for other work only ever adds to it.
/// Throws UsageError.
CostStudy measure_cost(const Scene& scene, const CostOptions& options);

using CostValue = double (*)(const CostPoint& point);

/// One value of each point.
std::vector<double> cost_column(const CostSweep& sweep, CostValue value);
/// What the sweep varies: the number of probes, or surfels a probe.
std::vector<double> cost_variable(const CostSweep& sweep);

}  // namespace plumbline::reports
