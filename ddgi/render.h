// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scenes/image.h"
#include "scenes/scene.h"

namespace plumbline::ddgi {

/// How the probes are built, lit and looked up.
struct DdgiOptions {
    std::string model = "conserving";
    int surfels = 64;                   ///< rays a probe
    std::map<std::string, double> set;  ///< constants of the model by their published names
    bool gi = true;
    bool cache = true;          ///< false: every surfel is placed afresh each frame
    int shadow_rays = 1;        ///< a pixel sample and light
    std::optional<int> updates; ///< at the last frame; none: until converged
    std::optional<float> spacing;
};

/// What one frame took, and what it counted.
struct FrameFigures {
    double bvh_ms = 0;      ///< moving the geometry
    double place_ms = 0;    ///< tracing surfel rays
    double light_ms = 0;    ///< shadow rays of surfels, feedback and propagation
    double primary_ms = 0;  ///< camera and shadow rays of the picture
    std::uint64_t probes = 0;
    std::uint64_t surfels = 0;      ///< probes * surfels a probe
    std::uint64_t surfels_hit = 0;  ///< those on a surface
    std::uint64_t replaced = 0;     ///< those placed this frame
    std::uint64_t shadow_rays = 0;
    int updates = 0;               ///< probe updates done at this frame
    double relative_change = 0;    ///< of the last update, largest over probes
    bool converged = false;
};

/// A finished picture with the layers that the README lists, and its last frame's figures.
struct DdgiResult {
    Image image;
    FrameFigures figures;
    double seconds;  ///< for everything, from the first frame on
};

/// Plays the scene to `frame` and renders it there: see DdgiOptions::updates.
/// Throws UsageError for an unknown model, constant or surfel count.
DdgiResult render(const Scene& scene, int frame, const DdgiOptions& options);

}  // namespace plumbline::ddgi
