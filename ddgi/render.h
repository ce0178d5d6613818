// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ddgi/probe_options.h"
#include "ddgi/step_times.h"
#include "scenes/image.h"
#include "scenes/scene.h"

namespace plumbline::ddgi {

/// How the probes are built, lit and looked up.
struct DdgiOptions {
    std::string model = "conserving";
    int surfels = 64;                   ///< rays a probe
    std::map<std::string, double> set;  ///< constants of the model by their published names
    ProbeOptions probes;                ///< for the model conserving
    bool gi = true;
    bool cache = true;                ///< false: every surfel is placed afresh each frame
    int shadow_rays = 1;              ///< a pixel sample and light
    std::optional<int> edge_samples;  ///< of a pixel on an edge; none: what the model asks for
    std::optional<int> updates;       ///< at the last frame; none: until converged
    std::optional<float> spacing;
    bool spectral_radius = false;  ///< measure it: see DdgiResult
    /// Surfels that an update re-places or lights again at most, the others wait: see SurfelQueue;
    /// none: all at once.
    std::optional<int> budget = std::nullopt;
    /// Surfels in one cell so wide, in spacings, share their light: see SurfelCells; 0: none do.
    double share = 0.;
};

/// What one frame took, and what it counted.
struct FrameFigures {
    double bvh_ms = 0;      ///< moving the geometry
    double place_ms = 0;    ///< tracing surfel rays
    double light_ms = 0;    ///< shadow rays of surfels, and all probe updates
    double primary_ms = 0;  ///< camera rays, shadow rays and look-ups of the picture
    std::uint64_t probes = 0;
    std::uint64_t surfels = 0;      ///< probes * surfels a probe
    std::uint64_t surfels_hit = 0;  ///< those on a surface
    std::uint64_t replaced = 0;     ///< those placed this frame
    std::uint64_t shadow_rays = 0;  ///< of surfels and of the picture
    std::uint64_t surfel_shadow_rays = 0;
    int updates = 0;             ///< probe updates at this frame
    double relative_change = 0;  ///< of the last update, largest over probes
    bool converged = false;  ///< relative_change is below convergence_threshold, no surfel waits
    std::uint64_t non_finite = 0;       ///< values of the picture that are not finite
    std::uint64_t surfels_lit = 0;      ///< of surfels_hit, those with light of their own
    std::uint64_t surfels_waiting = 0;  ///< for their turn in the budget
    int oldest_wait = 0;                ///< of these, in updates since it was touched
    StepTimes steps;                    ///< what place_ms and light_ms are made of
};

/// A still is updated until no probe changes by more than this, relative to its largest value.
constexpr double convergence_threshold = 1e-4;
/// ... or until so many updates are done.
constexpr int most_updates = 1000;

/// A finished picture with the layers that the README lists, and its last frame's figures.
struct DdgiResult {
    Image image;
    FrameFigures figures;
    double seconds;                           ///< for everything, from the first frame on
    std::map<std::string, double> constants;  ///< of the model, as used, by their published names
    std::vector<std::string> notes;           ///< what a user should know, one line each
    /// Of the probe update at this frame, if asked for: at 1 or more the probes feed each other
    /// more light than they lose (see spectral_radius.h).
    std::optional<double> spectral_radius = std::nullopt;
    /// The multiBounceIntensity at which the radius is 1, where the one asked for is at or above.
    std::optional<double> critical_multi_bounce = std::nullopt;
    double radius_seconds = 0;  ///< that these two took; not part of `seconds`
};

/// Plays the scene to `frame` and renders it there: see DdgiOptions::updates.
/// Throws UsageError for an unknown model, constant or surfel count.
DdgiResult render(const Scene& scene, int frame, const DdgiOptions& options);

}  // namespace plumbline::ddgi
