// SPDX-License-Identifier: Apache-2.0
#include "reports/sequence_summary.h"

#include <fmt/core.h>

#include <stdexcept>

#include "reports/machine.h"
#include "reports/published_timings.h"

namespace plumbline::reports {

namespace {

using nlohmann::ordered_json;

/// Of as many played frames [Dellson 2023, section 5.3.3].
constexpr std::size_t published_left_out = 79;
constexpr std::size_t published_frames = 600;

const SequenceRun& run_named(const Sequence& sequence, const std::string& name, int per_probe) {
    for (const SequenceRun& run : sequence.runs)
        if (run.configuration.name == name && run.configuration.per_probe == per_probe) return run;
    throw std::logic_error("no configuration " + name);
}

ordered_json number(const std::optional<SequenceMeans>& means, double SequenceMeans::*member) {
    return means ? ordered_json(*means.*member) : ordered_json();
}

ordered_json run_json(const Sequence& sequence, const SequenceRun& run) {
    const auto still = sequence_means(sequence, run, false);
    const auto animated = sequence_means(sequence, run, true);
    ordered_json json;
    json["name"] = run.configuration.name;
    json["per_probe"] = run.configuration.per_probe;
    json["probe_update_static_ms"] = number(still, &SequenceMeans::probe_update_ms);
    json["probe_update_animated_ms"] = number(animated, &SequenceMeans::probe_update_ms);
    json["primary_static_ms"] = number(still, &SequenceMeans::primary_ms);
    json["primary_animated_ms"] = number(animated, &SequenceMeans::primary_ms);
    json["replaced_static"] = number(still, &SequenceMeans::replaced);
    json["replaced_animated"] = number(animated, &SequenceMeans::replaced);
    json["surfel_shadow_rays_static"] = number(still, &SequenceMeans::surfel_shadow_rays);
    json["surfel_shadow_rays_animated"] = number(animated, &SequenceMeans::surfel_shadow_rays);
    json["csv"] = run.configuration.file + ".csv";
    return json;
}

ordered_json published_json(const std::string& scene) {
    ordered_json rows = ordered_json::array();
    for (const PublishedTiming& timing : published_timings()) {
        if (timing.scene != scene) continue;
        rows.push_back({{"name", timing.configuration},
                        {"per_probe", timing.per_probe},
                        {"runs", timing.runs},
                        {"probe_update_static_ms", timing.probe_update_static_ms},
                        {"probe_update_animated_ms", timing.probe_update_animated_ms},
                        {"primary_static_ms", timing.primary_static_ms},
                        {"primary_animated_ms", timing.primary_animated_ms}});
    }
    return rows;
}

/// Saving in percent between two means while something moves.
std::optional<double> saving(const Sequence& sequence, double SequenceMeans::*member) {
    const auto with = sequence_means(sequence, run_named(sequence, "full_gi", 64), true);
    const auto without = sequence_means(sequence, run_named(sequence, "no_surfels", 64), true);
    if (!with || !without || *without.*member == 0) return std::nullopt;
    return 100 * (1 - *with.*member / (*without.*member));
}

ordered_json or_null(const std::optional<double>& value) {
    return value ? ordered_json(*value) : ordered_json();
}

}  // namespace

std::size_t frames_left_out(const Sequence& sequence) {
    const std::size_t frames = sequence.scene_frames.size();
    return (frames * published_left_out + published_frames - 1) / published_frames;
}

std::optional<SequenceMeans> sequence_means(const Sequence& sequence, const SequenceRun& run,
                                            bool moved) {
    SequenceMeans sum;
    for (std::size_t i = frames_left_out(sequence); i < run.frames.size(); ++i) {
        if (sequence.moved[i] != moved) continue;
        const SequenceFrame& frame = run.frames[i];
        ++sum.frames;
        sum.probe_update_ms += frame.probe_update_ms();
        sum.primary_ms += frame.primary_ms;
        sum.replaced += static_cast<double>(frame.replaced);
        sum.surfel_shadow_rays += static_cast<double>(frame.surfel_shadow_rays);
    }
    if (sum.frames == 0) return std::nullopt;
    for (double* mean :
         {&sum.probe_update_ms, &sum.primary_ms, &sum.replaced, &sum.surfel_shadow_rays})
        *mean /= sum.frames;
    return sum;
}

std::optional<double> saving_animated_percent(const Sequence& sequence) {
    return saving(sequence, &SequenceMeans::probe_update_ms);
}

ordered_json summary_json(const Sequence& sequence, const std::string& scene) {
    ordered_json json;
    json["scene"] = scene;
    json["model"] = sequence.model;
    json["frames"] = sequence.scene_frames.size();
    json["frames_left_out"] = frames_left_out(sequence);
    json["repeats"] = sequence.repeats;
    json["threads"] = this_machine().threads;
    json["configurations"] = ordered_json::array();
    for (const SequenceRun& run : sequence.runs)
        json["configurations"].push_back(run_json(sequence, run));
    json["saving_animated_percent"] = or_null(saving_animated_percent(sequence));
    json["saving_animated_surfels_percent"] = or_null(saving(sequence, &SequenceMeans::replaced));
    json["published"] = {{"configurations", published_json(scene)},
                         {"saving_animated_percent", or_null(published_saving_percent(scene))}};
    return json;
}

std::string sequence_csv(const Sequence& sequence, const SequenceRun& run) {
    std::string csv =
        "frame,scene_frame,moved,probe_update_ms,place_ms,light_ms,primary_ms,bvh_ms,replaced,"
        "surfel_shadow_rays,picture_shadow_rays\n";
    for (std::size_t i = 0; i < run.frames.size(); ++i) {
        const SequenceFrame& frame = run.frames[i];
        csv += fmt::format("{},{},{:d},{:.5f},{:.5f},{:.5f},{:.5f},{:.5f},{},{},{}\n", i,
                           sequence.scene_frames[i], static_cast<bool>(sequence.moved[i]),
                           frame.probe_update_ms(), frame.place_ms, frame.light_ms,
                           frame.primary_ms, frame.bvh_ms, frame.replaced, frame.surfel_shadow_rays,
                           frame.picture_shadow_rays);
    }
    return csv;
}

}  // namespace plumbline::reports
