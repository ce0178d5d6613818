// SPDX-License-Identifier: Apache-2.0
#include "reports/sequence_page.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "reports/published_timings.h"
#include "reports/sequence_summary.h"
#include "reports/words.h"

namespace plumbline::reports {

namespace {

/// Left out of charts as "extreme outliers": 10 of 600 frames [Dellson 2023, section 5.3.3].
constexpr std::size_t outliers_of_600 = 10;

std::size_t first_charted(const Sequence& sequence) {
    return (sequence.scene_frames.size() * outliers_of_600 + 599) / 600;
}

/// The first and last frame in which something moves; empty if none does.
std::vector<double> animation_marks(const Sequence& sequence) {
    const auto first = std::find(sequence.moved.begin(), sequence.moved.end(), true);
    if (first == sequence.moved.end()) return {};
    const auto last = std::find(sequence.moved.rbegin(), sequence.moved.rend(), true);
    return {double(first - sequence.moved.begin()), double(sequence.moved.rend() - last) - 1};
}

/// Of the published chart that shows the same, for the two scenes that have one.
std::string figure_number(const std::string& scene, std::size_t index) {
    constexpr std::size_t first_of_cornell_box = 10;
    constexpr std::size_t first_of_room = 18;
    if (scene == "cornell-box") return fmt::format(" (figure 5.{})", first_of_cornell_box + index);
    if (scene == "room-with-door") return fmt::format(" (figure 5.{})", first_of_room + index);
    return "";
}

StudySeries over_frames(const Sequence& sequence, const SequenceRun& run, const std::string& label,
                        std::size_t color, double (*value)(const SequenceFrame&)) {
    StudySeries series{label, fmt::format("series-{}", color), {}, {}};
    for (std::size_t i = first_charted(sequence); i < run.frames.size(); ++i) {
        series.x.push_back(static_cast<double>(i));
        series.y.push_back(value(run.frames[i]));
    }
    return series;
}

double probe_update(const SequenceFrame& frame) { return frame.probe_update_ms(); }
double primary(const SequenceFrame& frame) { return frame.primary_ms; }
double replaced(const SequenceFrame& frame) { return static_cast<double>(frame.replaced); }

StudyChart frames_chart(const Sequence& sequence, const std::string& caption,
                        const std::string& y_title) {
    StudyChart chart;
    chart.caption = caption;
    chart.x_title = "frame";
    chart.y_title = y_title;
    chart.marks = animation_marks(sequence);
    return chart;
}

StudySection frames_section(const Sequence& sequence, const std::string& scene) {
    StudySection section{"Each configuration over the frames", {}, {}, {}, {}};
    section.paragraphs.emplace_back(
        "Dashed vertical lines stand where the animation begins and ends.");
    std::size_t figure = 0;
    StudyChart together = frames_chart(sequence, "", "probe update, ms");
    StudyChart counts = frames_chart(sequence,
                                     "Surfels re-placed a frame, all configurations: the "
                                     "same counts on every machine",
                                     "surfels");
    for (const SequenceRun& run : sequence.runs) {
        const std::string& title = run.configuration.title;
        StudyChart chart =
            frames_chart(sequence, title + figure_number(scene, figure), "milliseconds");
        chart.series = {over_frames(sequence, run, "probe update", 0, probe_update),
                        over_frames(sequence, run, "primary rays", 2, primary)};
        section.charts.push_back(chart);
        together.series.push_back(over_frames(sequence, run, title, figure, probe_update));
        counts.series.push_back(over_frames(sequence, run, title, figure, replaced));
        ++figure;
    }
    together.caption = "Probe update, all configurations" + figure_number(scene, figure);
    section.charts.push_back(together);
    section.charts.push_back(counts);
    return section;
}

std::string ms_text(const std::optional<SequenceMeans>& means, double SequenceMeans::*member) {
    return means ? number_text(*means.*member) : "none";
}

std::string replaced_text(const std::optional<SequenceMeans>& means) {
    return means ? count_text(static_cast<std::uint64_t>(std::llround(means->replaced))) : "none";
}

double value_of(const std::optional<SequenceMeans>& means, double SequenceMeans::*member) {
    return means ? *means.*member : 0;
}

StudySection averages_section(const Sequence& sequence, const std::string& scene) {
    StudyChart chart;
    chart.caption = "Averages while static and while animated" + figure_number(scene, 7);
    chart.y_title = "milliseconds";
    chart.series = {{"probe update, static", "series-0", {}, {}},
                    {"probe update, animated", "series-1", {}, {}},
                    {"primary rays, static", "series-2", {}, {}},
                    {"primary rays, animated", "series-3", {}, {}}};
    StudyTable table{
        "Means a frame, milliseconds and counts",
        {"Configuration", "probe update, static", "probe update, animated", "primary rays, static",
         "primary rays, animated", "surfels re-placed, static", "surfels re-placed, animated"},
        {}};
    for (const SequenceRun& run : sequence.runs) {
        const auto still = sequence_means(sequence, run, false);
        const auto animated = sequence_means(sequence, run, true);
        chart.labels.push_back(run.configuration.title);
        std::vector<std::string> row{run.configuration.title};
        std::size_t series = 0;
        for (const auto member : {&SequenceMeans::probe_update_ms, &SequenceMeans::primary_ms}) {
            for (const auto* means : {&still, &animated}) {
                chart.series[series++].y.push_back(value_of(*means, member));
                row.push_back(ms_text(*means, member));
            }
        }
        for (const auto* means : {&still, &animated}) row.push_back(replaced_text(*means));
        table.rows.push_back(row);
    }
    return {"Averages", {}, {table}, {chart}, {}};
}

StudySection published_section(const std::string& scene) {
    StudyTable table{"Published means, milliseconds a frame",
                     {"Configuration", "runs", "probe update, static", "probe update, animated",
                      "primary rays, static", "primary rays, animated"},
                     {}};
    for (const SequenceConfiguration& configuration : sequence_configurations()) {
        const PublishedTiming* timing =
            published_timing(scene, configuration.name, configuration.per_probe);
        if (timing == nullptr) continue;
        table.rows.push_back({configuration.title, std::to_string(timing->runs),
                              number_text(timing->probe_update_static_ms),
                              number_text(timing->probe_update_animated_ms),
                              number_text(timing->primary_static_ms),
                              number_text(timing->primary_animated_ms)});
    }
    return {"What was published",
            {"Dellson 2023, on an NVIDIA RTX 2070 Super at 1920 x 1080. Ratios of one column "
             "compare with ours; milliseconds of another machine and picture size do not. A "
             "published static frame lights every surfel again, rays to the light included; here "
             "a frame in which nothing changed re-uses what it has, and once the probes have "
             "settled it does nothing."},
            {table},
            {},
            {}};
}

std::string saving_sentence(const Sequence& sequence, const std::string& scene) {
    const auto saved = saving_animated_percent(sequence);
    if (!saved) return "Nothing moves in this scene, so there is no saving to tell.";
    std::string text = fmt::format(
        "While something moves, keeping surfels saves {:.1f} % of the probe update, at 64 rays a "
        "probe",
        *saved);
    if (const auto published = published_saving_percent(scene))
        text += fmt::format(" (published: {:.1f} %)", *published);
    return text + ".";
}

}  // namespace

StudyPage sequence_page(const Sequence& sequence, const std::string& scene,
                        const std::string& command) {
    StudyPage page;
    page.title = "Timing study: " + scene;
    page.command = command;
    page.lead = {
        saving_sentence(sequence, scene),
        fmt::format("Model {}, {} frames spread over the scene's own, each {}. Averages leave out "
                    "the first {} frames, charts the first {}; animated frames are those in which "
                    "something moved. The probe update is placing and lighting surfels and "
                    "updating the probes; rebuilding the acceleration structure is part of neither "
                    "time.",
                    sequence.model, sequence.scene_frames.size(),
                    sequence.repeats == 1 ? "timed once"
                                          : fmt::format("the mean of {} runs", sequence.repeats),
                    frames_left_out(sequence), first_charted(sequence))};
    page.sections = {averages_section(sequence, scene), frames_section(sequence, scene)};
    if (published_saving_percent(scene)) page.sections.push_back(published_section(scene));
    return page;
}

}  // namespace plumbline::reports
