// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ddgi/render.h"
#include "scenes/image.h"
#include "scenes/scene.h"

namespace plumbline::reports {

/// How closely an animation is looked at.
struct AnimationEffort {
    int steps;      ///< from the first key to the last
    double pixels;  ///< of a picture, in the camera's proportions
    int truth_spp;  ///< of each frame's truth
};

/// The error of one picture of a moving model, indirect layer.
struct MovingError {
    double mean_ratio;
    double rmse;      ///< noise of the truth included
    double bias_mse;  ///< the truth's noise taken off: an estimate, which may be below 0
};

/// The error of `picture`, whose frame `truth` shows.
MovingError moving_error(const Image& truth, const Image& picture);

struct MovingModel {
    std::string title;
    std::vector<MovingError> errors;  ///< one a frame of AnimationErrors
};

/// How far models are from the truth while a scene moves.
struct AnimationErrors {
    int first, last;  ///< keys between which it moves
    int width, height, truth_spp;
    int updates;                      ///< of the probes at each frame
    std::vector<int> frames;          ///< the last of them are past `last`
    std::vector<double> truth_means;  ///< of the indirect layer
    std::vector<MovingModel> models;
};

/// The first and the last frame of all keys, in the scene's frames; none if nothing ever moves.
std::optional<std::pair<int, int>> moving_frames(const Scene& scene);

/// A model by its title, and how it runs.
using TitledOptions = std::pair<std::string, ddgi::DdgiOptions>;

/// Plays the scene with each model as a viewer would see it, with one probe update a frame, but
/// with the geometry moving in steps of several frames, from probes that had settled before the
/// first step; then two steps more, in which nothing moves. At most ten updates are given to a
/// step. Each picture is held against a truth of its own frame. None if nothing moves.
std::optional<AnimationErrors> measure_animation(const Scene& scene,
                                                 const std::vector<TitledOptions>& models,
                                                 const AnimationEffort& effort);

}  // namespace plumbline::reports
