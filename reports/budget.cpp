// SPDX-License-Identifier: Apache-2.0
#include "reports/budget.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "compare/metrics.h"
#include "ddgi/picture.h"
#include "ddgi/volume.h"
#include "pathtracer/render.h"
#include "scenes/errors.h"
#include "scenes/progress.h"

namespace plumbline::reports {

namespace {

/// Frames at rest after the last key, as a share of those that move.
constexpr int moving_to_still = 3;

const std::string layer = "indirect";

void check(const BudgetOptions& options) {
    for (const int budget : options.budgets) {
        if (budget >= 1) continue;
        throw UsageError("--budgets", fmt::format("{} surfels", budget), "give 1 or more each");
    }
    // Two batches of 16: with fewer the truth's noise, which is taken off, is overstated.
    constexpr int fewest = 2 * 16;
    if (options.truth_spp < fewest)
        throw UsageError("--spp",
                         fmt::format("{} samples do not tell a truth's noise", options.truth_spp),
                         fmt::format("give {} or more", fewest));
    if (options.truths < 2)
        throw UsageError("--truths", fmt::format("{} frames", options.truths), "give 2 or more");
}

std::pair<int, int> moving_frames_of(const Scene& scene) {
    if (const auto range = moving_frames(scene)) return *range;
    throw UsageError("scene", fmt::format("nothing moves in {}", scene.name),
                     "give a scene with an animation, such as room-with-door");
}

/// `count` of the frames, the first and the last among them.
std::vector<int> spread_over(const std::vector<int>& frames, int count) {
    std::vector<int> chosen;
    const auto last = static_cast<double>(frames.size() - 1);
    for (int i = 0; i < count; ++i) {
        const int frame = frames[static_cast<std::size_t>(std::lround(last * i / (count - 1)))];
        if (chosen.empty() || frame > chosen.back()) chosen.push_back(frame);
    }
    return chosen;
}

/// What a run is held against.
struct Expected {
    std::vector<Image> truths;    ///< one a frame of BudgetStudy::held
    std::vector<Image> pictures;  ///< one a frame, without a budget; none yet for that run itself
};

double lag_of(const Expected& expected, std::size_t frame, const Image& picture) {
    if (frame >= expected.pictures.size()) return 0.;
    return compare::pixel_metrics(compare::pair_layers(expected.pictures[frame], picture, layer))
        .rmse;
}

/// Of a picture, the layer alone.
Image indirect_of(const Image& picture) {
    Image indirect(picture.width(), picture.height());
    const auto from = picture.layer(layer);
    const auto to = indirect.layer(layer);
    for (std::size_t c = 0; c < from.size(); ++c) std::ranges::copy(from[c], to[c].begin());
    return indirect;
}

template <typename Pictures>
BudgetRun play(const Scene& scene, const BudgetStudy& study, std::optional<int> budget,
               const Expected& expected, const Pictures& played) {
    ddgi::DdgiOptions options;
    options.model = study.model;
    options.budget = budget;
    ddgi::ProbeVolume volume(scene, options);
    volume.move_to(study.first);
    volume.converge();
    BudgetRun run{budget, {}, {}};
    for (std::size_t i = 0; i < study.frames.size(); ++i) {
        volume.move_to(std::min(study.frames[i], study.last));
        volume.update();
        const ddgi::FrameFigures& figures = volume.figures();
        const Image picture = ddgi::take_picture(volume.tracer(), volume.model(), &volume,
                                                 ddgi::picture_options(options, volume.model()))
                                  .image;
        run.frames.push_back({figures.place_ms + figures.light_ms, figures.replaced,
                              figures.surfel_shadow_rays, figures.surfels_waiting,
                              figures.oldest_wait, lag_of(expected, i, picture)});
        const std::size_t held = run.errors.size();
        if (held < study.held.size() && study.held[held] == study.frames[i])
            run.errors.push_back(moving_error(expected.truths[held], picture));
        played(picture);
    }
    return run;
}

std::uint64_t surfels_of(const Scene& scene, const BudgetOptions& options) {
    ddgi::DdgiOptions ddgi;
    ddgi.model = options.model;
    return ddgi::ProbeVolume(scene, ddgi).cache().surfels().size();
}

}  // namespace

std::vector<int> default_budgets(std::uint64_t surfels) {
    std::vector<int> budgets;
    for (const double share : {.003, .01, .03})
        budgets.push_back(std::max(1, static_cast<int>(share * static_cast<double>(surfels))));
    return budgets;
}

BudgetStudy measure_budget(const Scene& scene, const BudgetOptions& options) {
    check(options);
    const auto [first, last] = moving_frames_of(scene);
    BudgetStudy study{options.model,
                      first,
                      last,
                      scene.camera.width,
                      scene.camera.height,
                      options.truth_spp,
                      surfels_of(scene, options),
                      {},
                      {},
                      {}};
    const int still = std::max(1, (last - first) / moving_to_still);
    for (int frame = first; frame <= last + still; ++frame) study.frames.push_back(frame);
    // The first frame is the same for all budgets.
    study.held = spread_over({study.frames.begin() + 1, study.frames.end()}, options.truths);
    const std::vector<int> budgets =
        options.budgets.empty() ? default_budgets(study.surfels) : options.budgets;
    Progress progress("Budgets of " + scene.name,
                      study.held.size() + study.frames.size() * (budgets.size() + 1));
    Expected expected;
    pathtracer::RenderOptions render;
    render.spp = options.truth_spp;
    for (const int frame : study.held) {
        expected.truths.push_back(pathtracer::render(scene, std::min(frame, last), render).image);
        progress.advance();
    }
    std::vector<Image> pictures;
    study.runs.push_back(play(scene, study, std::nullopt, expected, [&](const Image& picture) {
        pictures.push_back(indirect_of(picture));
        progress.advance();
    }));
    expected.pictures = std::move(pictures);
    for (const int budget : budgets)
        study.runs.push_back(
            play(scene, study, budget, expected, [&](const Image&) { progress.advance(); }));
    return study;
}

}  // namespace plumbline::reports
