// SPDX-License-Identifier: Apache-2.0
#include "reports/animation.h"

#include <algorithm>
#include <cmath>

#include "compare/comparison.h"
#include "ddgi/play.h"
#include "pathtracer/render.h"
#include "reports/layer_statistics.h"
#include "reports/picture_size.h"
#include "scenes/progress.h"

namespace plumbline::reports {

namespace {

constexpr int most_updates_a_step = 10;
constexpr int updates_to_settle = 40;  ///< before anything moves
constexpr int still_steps = 2;         ///< after the last key

template <typename T>
void widen(std::optional<std::pair<int, int>>& range, const Track<T>& track) {
    if (track.frames.size() < 2) return;
    const int first = static_cast<int>(std::floor(track.frames.front()));
    const int last = static_cast<int>(std::ceil(track.frames.back()));
    range = range ? std::pair(std::min(range->first, first), std::max(range->second, last))
                  : std::pair(first, last);
}

/// Frames at which pictures are held against the truth.
std::vector<int> frames_between(int first, int last, int steps, int frames) {
    std::vector<int> chosen;
    for (int i = 0; i <= steps + still_steps; ++i) {
        const int frame = first + static_cast<int>(std::lround(double(last - first) * i / steps));
        if (frame < frames && (chosen.empty() || frame > chosen.back())) chosen.push_back(frame);
    }
    return chosen;
}

/// Every frame as often as the probes are updated there.
std::vector<int> frames_played(const AnimationErrors& animation) {
    std::vector<int> played(updates_to_settle, animation.frames.front());
    for (const int frame : animation.frames) played.insert(played.end(), animation.updates, frame);
    return played;
}

MovingModel play_model(const Scene& scene, const TitledOptions& model,
                       const AnimationErrors& animation, const std::vector<Image>& truths) {
    MovingModel moving{model.first, {}};
    const std::vector<int> played = frames_played(animation);
    std::size_t updates = 0;
    ddgi::play(scene, played, model.second, [&](const ddgi::FrameFigures&, const Image& picture) {
        const std::size_t moved = ++updates - std::min<std::size_t>(updates, updates_to_settle);
        if (moved > 0 && moved % static_cast<std::size_t>(animation.updates) == 0)
            moving.errors.push_back(moving_error(truths[moving.errors.size()], picture));
    });
    return moving;
}

}  // namespace

MovingError moving_error(const Image& truth, const Image& picture) {
    const compare::Comparison comparison = compare::compare_images(truth, picture, "indirect");
    const double mse = comparison.metrics.rmse * comparison.metrics.rmse;
    return {layer_mean(picture, "indirect") / layer_mean(truth, "indirect"),
            comparison.metrics.rmse, comparison.noise ? comparison.noise->bias_mse : mse};
}

std::optional<std::pair<int, int>> moving_frames(const Scene& scene) {
    std::optional<std::pair<int, int>> range;
    for (const Object& object : scene.objects) {
        widen(range, object.animation.translation);
        widen(range, object.animation.rotation);
        widen(range, object.animation.scale);
    }
    if (!range) return range;
    const int end = scene.frames - 1;
    range = {std::clamp(range->first, 0, end), std::clamp(range->second, 0, end)};
    return range->first < range->second ? range : std::nullopt;
}

std::optional<AnimationErrors> measure_animation(const Scene& scene,
                                                 const std::vector<TitledOptions>& models,
                                                 const AnimationEffort& effort) {
    const auto range = moving_frames(scene);
    if (!range) return std::nullopt;
    Scene small = scene;
    set_default_size(small.camera, {},
                     std::min(effort.pixels, double(scene.camera.width) * scene.camera.height));
    AnimationErrors animation{
        range->first,
        range->second,
        small.camera.width,
        small.camera.height,
        effort.truth_spp,
        0,
        frames_between(range->first, range->second, effort.steps, scene.frames),
        {},
        {}};
    animation.updates =
        std::clamp((range->second - range->first) / effort.steps, 1, most_updates_a_step);
    std::vector<Image> truths;
    pathtracer::RenderOptions render;
    render.spp = effort.truth_spp;
    Progress progress("Animation of " + scene.name, animation.frames.size() + models.size());
    for (const int frame : animation.frames) {
        truths.push_back(pathtracer::render(small, frame, render).image);
        animation.truth_means.push_back(layer_mean(truths.back(), "indirect"));
        progress.advance();
    }
    for (const TitledOptions& model : models) {
        animation.models.push_back(play_model(small, model, animation, truths));
        progress.advance();
    }
    return animation;
}

}  // namespace plumbline::reports
