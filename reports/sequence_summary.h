// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "reports/sequence.h"

namespace plumbline::reports {

/// Means over the frames of one kind.
struct SequenceMeans {
    int frames = 0;
    double probe_update_ms = 0;
    double primary_ms = 0;
    double replaced = 0;            ///< surfels re-placed a frame
    double surfel_shadow_rays = 0;  ///< a frame
};

/// What is left out at the start, before times settle: 79 of 600 frames [Dellson 2023, section
/// 5.3.3], or the same share.
std::size_t frames_left_out(const Sequence& sequence);

/// Means over frames in which something moved, or over those in which nothing did, without
/// frames_left_out(). None if there are no such frames.
std::optional<SequenceMeans> sequence_means(const Sequence& sequence, const SequenceRun& run,
                                            bool moved);

/// By how many percent surfels lower the mean probe update while something moves, at 64 rays a
/// probe. None if nothing moves.
std::optional<double> saving_animated_percent(const Sequence& sequence);

/// summary.json: means, saving, what was counted, and the published figures for a scene that has
/// some.
nlohmann::ordered_json summary_json(const Sequence& sequence, const std::string& scene);

/// One line a frame of a run: times in milliseconds, and counts.
std::string sequence_csv(const Sequence& sequence, const SequenceRun& run);

}  // namespace plumbline::reports
