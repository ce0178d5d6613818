// SPDX-License-Identifier: Apache-2.0
#include "reports/cost.h"

#include <fmt/core.h>

#include <algorithm>

#include "ddgi/volume.h"
#include "reports/allocated.h"
#include "scenes/errors.h"
#include "scenes/progress.h"

namespace plumbline::reports {

namespace {

constexpr int surfels_over_spacings = 64;

void check(const CostOptions& options) {
    if (options.repeats < 1)
        throw UsageError("--repeats", fmt::format("{} repeats", options.repeats), "give 1 or more");
    if (options.spacings.empty())
        throw UsageError("--spacings", "no spacing", "give one or more, such as 20,10");
}

CostPoint measure_once(const Scene& scene, const ddgi::DdgiOptions& options) {
    const std::size_t before = allocated_bytes();
    ddgi::ProbeVolume volume(scene, options);
    volume.move_to(0);
    CostPoint point{};
    point.spacing = volume.cache().grid().spacing;
    point.per_probe = options.surfels;
    point.probes = volume.figures().probes;
    point.place_ms = volume.figures().place_ms;
    point.light_ms = volume.figures().light_ms;
    volume.update();
    point.update_ms = volume.figures().light_ms - point.light_ms;
    point.bytes = static_cast<double>(allocated_bytes() - before);
    return point;
}

CostPoint measure_point(const Scene& scene, const CostOptions& cost, float spacing, int surfels,
                        Progress& progress) {
    ddgi::DdgiOptions options;
    options.model = cost.model;
    options.spacing = spacing;
    options.surfels = surfels;
    CostPoint best = measure_once(scene, options);
    progress.advance();
    for (int i = 1; i < cost.repeats; ++i) {
        const CostPoint again = measure_once(scene, options);
        best.place_ms = std::min(best.place_ms, again.place_ms);
        best.light_ms = std::min(best.light_ms, again.light_ms);
        best.update_ms = std::min(best.update_ms, again.update_ms);
        progress.advance();
    }
    return best;
}

void fit(CostSweep& sweep) {
    const std::vector<double> x = cost_variable(sweep);
    const auto law = [&](CostValue value) { return fit_power_law(x, cost_column(sweep, value)); };
    sweep.place = law([](const CostPoint& point) { return point.place_ms; });
    sweep.update = law([](const CostPoint& point) { return point.update_ms; });
    sweep.total = law([](const CostPoint& point) { return point.total_ms(); });
    sweep.bytes = law([](const CostPoint& point) { return point.bytes; });
}

}  // namespace

std::vector<double> cost_column(const CostSweep& sweep, CostValue value) {
    std::vector<double> values;
    for (const CostPoint& point : sweep.points) values.push_back(value(point));
    return values;
}

std::vector<double> cost_variable(const CostSweep& sweep) {
    if (sweep.varied == "probes")
        return cost_column(sweep, [](const CostPoint& point) { return double(point.probes); });
    return cost_column(sweep, [](const CostPoint& point) { return double(point.per_probe); });
}

CostStudy measure_cost(const Scene& scene, const CostOptions& options) {
    check(options);
    CostStudy study{options.model,
                    options.repeats,
                    {"probes", {}, {}, {}, {}, {}},
                    {"surfels", {}, {}, {}, {}, {}}};
    Progress progress("Cost", (options.spacings.size() + options.surfels.size()) *
                                  static_cast<std::size_t>(options.repeats));
    for (const float spacing : options.spacings)
        study.probes.points.push_back(
            measure_point(scene, options, spacing, surfels_over_spacings, progress));
    for (const int surfels : options.surfels)
        study.surfels.points.push_back(
            measure_point(scene, options, probe_grid(scene).spacing, surfels, progress));
    fit(study.probes);
    fit(study.surfels);
    return study;
}

}  // namespace plumbline::reports
