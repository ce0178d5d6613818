// SPDX-License-Identifier: Apache-2.0
#include "reports/frontier.h"

#include <fmt/core.h>

#include <algorithm>

#include "ddgi/thesis_model.h"
#include "pathtracer/render.h"
#include "reports/frontier_points.h"
#include "reports/layer_statistics.h"
#include "reports/picture_size.h"
#include "scenes/errors.h"
#include "scenes/progress.h"

namespace plumbline::reports {

Spread spread_of(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    const double median =
        values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
    return {median, values.front(), values.back()};
}

FrontierEffort frontier_effort(bool quick) {
    if (quick) return {160. * 90., 256, {1, 4, 16, 64}, 2};
    return {320. * 180., 4096, {1, 4, 16, 64, 256, 1024}, 3};
}

void check(const FrontierOptions& options) {
    if (options.repeats < 2)
        throw UsageError("--repeats", fmt::format("{} repeats", options.repeats),
                         "give 2 or more: one picture tells neither its noise nor a spread");
}

Frontier measure_frontier(const Scene& scene, int frame, const Image& truth,
                          const FrontierOptions& options) {
    check(options);
    Frontier frontier{scene.name,
                      frame,
                      truth.width(),
                      truth.height(),
                      options.repeats,
                      layer_noise(truth, "indirect"),
                      {},
                      ddgi::thesis_obstacle(probe_grid(scene)).value_or("")};
    for (const int spp : options.spp)
        frontier.points.push_back(measure_path_tracer(scene, frame, truth, spp, options.repeats));
    Progress progress("Probes of " + scene.name, options.cases.size());
    for (const FrontierCase& subject : options.cases) {
        for (FrontierPoint& point : measure_probes(scene, frame, truth, subject, options.repeats))
            frontier.points.push_back(std::move(point));
        progress.advance();
    }
    return frontier;
}

Frontier measure_quick_frontier(const Scene& scene, int frame) {
    const FrontierEffort effort = frontier_effort(true);
    Scene small = scene;
    set_default_size(small.camera, {}, effort.pixels);
    pathtracer::RenderOptions render;
    render.spp = effort.truth_spp;
    const Image truth = pathtracer::render(small, frame, render).image;
    return measure_frontier(small, frame, truth,
                            {effort.spp, frontier_cases(scene, true), effort.repeats});
}

std::vector<TimedError> timed_errors(const Frontier& frontier, Budget budget) {
    std::vector<TimedError> points;
    for (const FrontierPoint& point : frontier.points) {
        if (!point.error) continue;
        if (budget == Budget::Still)
            points.push_back(
                {point.method, point.setting, point.seconds.median, point.error->median});
        else if (point.frame_seconds)
            points.push_back(
                {point.method, point.setting, point.frame_seconds->median, point.error->median});
    }
    return points;
}

}  // namespace plumbline::reports
