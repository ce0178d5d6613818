// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "reports/frontier_cases.h"
#include "reports/pareto.h"
#include "scenes/image.h"
#include "scenes/scene.h"

namespace plumbline::reports {

inline constexpr const char* path_tracer_method = "path tracer";

/// What repeated runs gave.
struct Spread {
    double median = 0;
    double least = 0;
    double most = 0;
};

/// Of at least one value.
Spread spread_of(std::vector<double> values);

/// One picture of the frontier: its error, of the indirect layer, and what it cost.
///
/// mse is what the comparison shows, the truth's noise included. error^2 = mse - truth's noise, and
/// splits into noise_mse, which another seed would change, and bias_mse, which it would not.
struct FrontierPoint {
    std::string method;   ///< "path tracer", or a model of ddgi and its storage
    std::string setting;  ///< "64 spp", "64 surfels, 16 updates"
    std::string options;  ///< of the subcommand that makes the picture
    double mse = 0;       ///< mean of the repeats
    double noise_mse = 0;
    double bias_mse = 0;  ///< an estimate, which may be below 0
    std::array<double, 2> bias_mse_ci95{};
    /// Root mean square over the pixels. None where the truth's noise explains all of mse.
    std::optional<Spread> error;
    Spread seconds;  ///< of a still, from nothing: for probes placing, lighting, updates, picture
    /// Of one more frame, its light settled: re-placing what moved, one update, and the picture.
    /// None for pictures of probes that are not settled.
    std::optional<Spread> frame_seconds;
    Spread place_ms, update_ms;  ///< of all surfels; of one update of all probes. 0 without probes
    Spread primary_ms;           ///< of the picture
    double bytes = 0;            ///< that probes and surfels hold; 0 without probes
    int updates = 0;
    std::uint64_t non_finite = 0;  ///< values that are left out of the figures
};

/// Accuracy against time on one scene.
struct Frontier {
    std::string scene;
    int frame;
    int width, height;
    int repeats;
    double truth_noise;  ///< RMSE of the truth's indirect layer from its own noise
    std::vector<FrontierPoint> points;
    std::string without_thesis{};  ///< why its model cannot run on the scene's grid; else empty
};

/// What is measured.
struct FrontierOptions {
    std::vector<int> spp{1, 4, 16, 64, 256};  ///< of the path tracer
    std::vector<FrontierCase> cases;          ///< of the probes
    int repeats = 3;                          ///< at least 2
};

/// How much is measured of a scene, with `quick` or without it.
struct FrontierEffort {
    double pixels;  ///< of a picture, in the camera's proportions
    int truth_spp;
    std::vector<int> spp;
    int repeats;
};
FrontierEffort frontier_effort(bool quick);

/// Throws UsageError for options that measure_frontier() cannot run: told before a truth is
/// rendered.
void check(const FrontierOptions& options);

/// Runs everything against `truth`, a picture of the scene's camera's size with variances of its
/// indirect layer. Repeats of the path tracer differ in their seed, which tells its noise from
/// bias; those of probes differ in their time only.
/// Throws UsageError, ImageError.
Frontier measure_frontier(const Scene& scene, int frame, const Image& truth,
                          const FrontierOptions& options);

/// What `plumbline frontier SCENE --quick` measures, truth and all.
Frontier measure_quick_frontier(const Scene& scene, int frame);

/// What a time is counted from.
enum class Budget {
    Still,  ///< a picture from nothing
    Frame,  ///< one more frame, whose probes have settled; the path tracer begins anew
};

/// The points that a budget knows and whose error the truth can tell, by their medians.
std::vector<TimedError> timed_errors(const Frontier& frontier, Budget budget);

}  // namespace plumbline::reports
