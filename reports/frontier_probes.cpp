// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <cmath>

#include "compare/comparison.h"
#include "ddgi/picture.h"
#include "ddgi/stopwatch.h"
#include "ddgi/volume.h"
#include "reports/allocated.h"
#include "reports/frontier_points.h"
#include "scenes/errors.h"

namespace plumbline::reports {

namespace {

const std::string layer = "indirect";

/// The updates after which a picture is taken, before the one with all of them.
constexpr std::array early_updates{1, 4, 16};

/// A picture of the probes as they were, and the times up to it.
struct Shot {
    ddgi::FrameFigures figures;  ///< light_ms of the surfels and of all updates so far
    double set_up_light_ms;      ///< the part of it before the first update
    double primary_ms;
    Image image;

    double update_ms() const { return (figures.light_ms - set_up_light_ms) / figures.updates; }
    double seconds() const {
        return (figures.bvh_ms + figures.place_ms + figures.light_ms + primary_ms) / 1e3;
    }
};

struct Run {
    std::vector<Shot> shots;  ///< the last one is settled
    double motion_ms;         ///< what moved since the frame before: geometry and surfels
    double bytes;
};

Shot shoot(const ddgi::ProbeVolume& volume, const ddgi::DdgiOptions& options, double light_ms) {
    const ddgi::Stopwatch watch;
    ddgi::Picture picture = ddgi::take_picture(volume.tracer(), volume.model(), &volume,
                                               ddgi::picture_options(options, volume.model()));
    return {volume.figures(), light_ms, watch.ms(), std::move(picture.image)};
}

/// What going on to `frame` from the one before moves; at frame 0, nothing.
double motion_ms(ddgi::ProbeVolume& volume, int frame) {
    volume.move_to(std::max(0, frame - 1));
    volume.move_to(frame);
    const ddgi::FrameFigures& figures = volume.figures();
    return figures.bvh_ms + figures.place_ms + figures.light_ms;
}

Run run_once(const Scene& scene, int frame, const ddgi::DdgiOptions& options) {
    const std::size_t before = allocated_bytes();
    ddgi::ProbeVolume volume(scene, options);
    volume.move_to(frame);
    const double light_ms = volume.figures().light_ms;
    Run run{};
    for (const int updates : early_updates) {
        while (volume.figures().updates < updates && !volume.figures().converged) volume.update();
        if (run.shots.empty())
            run.bytes = static_cast<double>(allocated_bytes()) - static_cast<double>(before);
        if (volume.figures().converged) break;
        run.shots.push_back(shoot(volume, options, light_ms));
    }
    volume.converge();
    run.shots.push_back(shoot(volume, options, light_ms));
    run.motion_ms = motion_ms(volume, frame);
    return run;
}

template <typename Value>
Spread spread_over(const std::vector<Run>& runs, const Value& value) {
    std::vector<double> values;
    for (const Run& run : runs) values.push_back(value(run));
    return spread_of(values);
}

/// All repeats give the same picture: its error is taken from the first.
void take_error(FrontierPoint& point, const Image& truth, const Image& picture) {
    const compare::LayerPair pair = compare::pair_layers(truth, picture, layer);
    const auto split = compare::split_noise(truth, picture, pair);
    if (!split)
        throw ImageError(truth.source, "the truth has no variances of its indirect layer",
                         "render it with `plumbline render`");
    const double rmse = compare::pixel_metrics(pair).rmse;
    point.mse = rmse * rmse;
    point.bias_mse = split->bias_mse;
    point.bias_mse_ci95 = split->bias_mse_ci95;
    point.non_finite = pair.non_finite;
    if (split->bias_mse > 0) point.error = spread_of({std::sqrt(split->bias_mse)});
}

FrontierPoint point_of(const std::vector<Run>& runs, std::size_t shot, const FrontierCase& subject,
                       const Image& truth) {
    const auto over = [&](auto value) {
        return spread_over(runs, [&](const Run& run) { return value(run.shots[shot]); });
    };
    const Shot& first = runs.front().shots[shot];
    const bool settled = shot + 1 == runs.front().shots.size();
    FrontierPoint point;
    point.method = subject.method;
    point.updates = first.figures.updates;
    point.setting = fmt::format("{}, {} update{}", subject.setting, point.updates,
                                point.updates == 1 ? "" : "s");
    point.options = subject.options + (settled ? "" : fmt::format(" --updates {}", point.updates));
    point.bytes = runs.front().bytes;
    point.place_ms = over([](const Shot& one) { return one.figures.place_ms; });
    point.update_ms = over([](const Shot& one) { return one.update_ms(); });
    point.primary_ms = over([](const Shot& one) { return one.primary_ms; });
    point.seconds = over([](const Shot& one) { return one.seconds(); });
    if (settled)
        point.frame_seconds = spread_over(runs, [&](const Run& run) {
            const Shot& last = run.shots.back();
            return (run.motion_ms + last.update_ms() + last.primary_ms) / 1e3;
        });
    take_error(point, truth, first.image);
    return point;
}

}  // namespace

std::vector<FrontierPoint> measure_probes(const Scene& scene, int frame, const Image& truth,
                                          const FrontierCase& subject, int repeats) {
    std::vector<Run> runs;
    for (int repeat = 0; repeat < repeats; ++repeat)
        runs.push_back(run_once(scene, frame, subject.ddgi));
    std::vector<FrontierPoint> points;
    for (std::size_t shot = 0; shot < runs.front().shots.size(); ++shot)
        points.push_back(point_of(runs, shot, subject, truth));
    return points;
}

}  // namespace plumbline::reports
