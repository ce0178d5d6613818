// SPDX-License-Identifier: Apache-2.0
#include "reports/sequence.h"

#include <fmt/core.h>

#include "ddgi/motion.h"
#include "ddgi/play.h"
#include "scenes/errors.h"
#include "scenes/progress.h"

namespace plumbline::reports {

namespace {

/// Below this the windows of the study would hold no frame.
constexpr int fewest_frames = 10;

void check(const SequenceOptions& options) {
    if (options.frames < fewest_frames)
        throw UsageError("--frames", fmt::format("{} frames", options.frames),
                         fmt::format("give {} or more", fewest_frames));
    if (options.repeats < 1)
        throw UsageError("--repeats", fmt::format("{} repeats", options.repeats), "give 1 or more");
}

std::vector<int> frames_played(const Scene& scene, int count) {
    std::vector<int> frames;
    for (std::int64_t i = 0; i < count; ++i)
        frames.push_back(static_cast<int>(i * scene.frames / count));
    return frames;
}

std::vector<bool> frames_that_move(const Scene& scene, const std::vector<int>& frames) {
    std::vector<bool> moved;
    World last = world_at(scene, frames.front());
    for (const int frame : frames) {
        World world = world_at(scene, frame);
        moved.push_back(!ddgi::motion_between(last, world).none());
        last = std::move(world);
    }
    return moved;
}

ddgi::DdgiOptions options_of(const SequenceConfiguration& configuration, const std::string& model) {
    ddgi::DdgiOptions options;
    options.model = model;
    options.gi = configuration.per_probe > 0;
    if (options.gi) options.surfels = configuration.per_probe;
    options.cache = configuration.cache;
    return options;
}

/// Adds a frame's times, and takes its counts.
void add(SequenceFrame& frame, const ddgi::FrameFigures& figures) {
    frame.place_ms += figures.place_ms;
    frame.light_ms += figures.light_ms;
    frame.primary_ms += figures.primary_ms;
    frame.bvh_ms += figures.bvh_ms;
    frame.replaced = figures.replaced;
    frame.surfel_shadow_rays = figures.surfel_shadow_rays;
    frame.picture_shadow_rays = figures.shadow_rays - figures.surfel_shadow_rays;
}

void divide_times(SequenceFrame& frame, double repeats) {
    for (double* time : {&frame.place_ms, &frame.light_ms, &frame.primary_ms, &frame.bvh_ms})
        *time /= repeats;
}

}  // namespace

const std::vector<SequenceConfiguration>& sequence_configurations() {
    static const std::vector<SequenceConfiguration> configurations{
        {"no_surfels", "no_surfels", "No surfels, 64 rays per probe", 64, false},
        {"full_gi", "full_gi_64", "Full GI, 64 surfels per probe", 64, true},
        {"full_gi", "full_gi_96", "Full GI, 96 surfels per probe", 96, true},
        {"full_gi", "full_gi_128", "Full GI, 128 surfels per probe", 128, true},
        {"full_gi", "full_gi_160", "Full GI, 160 surfels per probe", 160, true},
        {"gi_off", "gi_off", "GI off", 0, true}};
    return configurations;
}

Sequence measure_sequence(const Scene& scene, const SequenceOptions& options) {
    check(options);
    Sequence sequence{options.model, options.repeats, frames_played(scene, options.frames), {}, {}};
    sequence.moved = frames_that_move(scene, sequence.scene_frames);
    for (const SequenceConfiguration& configuration : sequence_configurations())
        sequence.runs.push_back(
            {configuration, std::vector<SequenceFrame>(sequence.scene_frames.size())});
    Progress progress("Sequence", static_cast<std::uint64_t>(options.frames) *
                                      static_cast<std::uint64_t>(options.repeats) *
                                      sequence.runs.size());
    for (int repeat = 0; repeat < options.repeats; ++repeat) {
        for (SequenceRun& run : sequence.runs) {
            std::size_t at = 0;
            ddgi::play(scene, sequence.scene_frames, options_of(run.configuration, options.model),
                       [&](const ddgi::FrameFigures& figures, const Image&) {
                           add(run.frames[at++], figures);
                           progress.advance();
                       });
        }
    }
    for (SequenceRun& run : sequence.runs)
        for (SequenceFrame& frame : run.frames) divide_times(frame, options.repeats);
    return sequence;
}

}  // namespace plumbline::reports
