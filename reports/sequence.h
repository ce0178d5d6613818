// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scenes/scene.h"

namespace plumbline::reports {

/// A way to run the probes that the timing study compares [Dellson 2023, table 5.2].
struct SequenceConfiguration {
    std::string name;   ///< full_gi, no_surfels or gi_off
    std::string file;   ///< name of its CSV file
    std::string title;  ///< as published
    int per_probe;      ///< surfels a probe; rays placed afresh each frame if not `cache`; 0: no GI
    bool cache;
};

/// The six, in the order of the published figures.
const std::vector<SequenceConfiguration>& sequence_configurations();

/// What a frame took, as means over repeats, and what it counted, which no repeat changes.
struct SequenceFrame {
    double place_ms = 0;    ///< tracing surfel rays
    double light_ms = 0;    ///< shadow rays of surfels and the probe update
    double primary_ms = 0;  ///< the picture
    double bvh_ms = 0;      ///< moving the geometry; part of neither measurement
    std::uint64_t replaced = 0;
    std::uint64_t surfel_shadow_rays = 0;
    std::uint64_t picture_shadow_rays = 0;

    double probe_update_ms() const { return place_ms + light_ms; }
};

struct SequenceRun {
    SequenceConfiguration configuration;
    std::vector<SequenceFrame> frames;  ///< one a frame of Sequence
};

/// The timing study of [Dellson 2023, section 5.3] on one scene.
struct Sequence {
    std::string model;
    int repeats = 0;
    std::vector<int> scene_frames;  ///< which frame of the scene each played frame shows
    std::vector<bool> moved;        ///< whether something moved since the frame before
    std::vector<SequenceRun> runs;  ///< in the order of sequence_configurations()
};

struct SequenceOptions {
    std::string model = "thesis";
    int frames = 600;
    int repeats = 1;
};

/// Plays `frames` frames, spread evenly over all of the scene's, in every configuration, and all of
/// that `repeats` times, so that a slow spell of the machine falls on all configurations alike.
/// Throws UsageError.
Sequence measure_sequence(const Scene& scene, const SequenceOptions& options);

}  // namespace plumbline::reports
