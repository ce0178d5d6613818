// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "compare/comparison.h"
#include "compare/energy_audit.h"
#include "compare/fit.h"
#include "ddgi/render.h"
#include "pathtracer/render.h"
#include "reports/animation.h"
#include "reports/frontier.h"
#include "reports/stages.h"
#include "scenes/effects.h"

namespace plumbline::reports {

/// How much work a report puts into each scene.
struct Quality {
    std::string name;
    int truth_spp;
    std::vector<int> path_tracer_spp;  ///< the pictures behind the path tracer's line
    AnimationEffort animation{};
    double transfer_pixels = 0;  ///< of the pictures between which constants are carried
    int transfer_spp = 0;        ///< of their truths
};

/// The default quality, or the one of --quick.
Quality quality_of(bool quick);

/// A layer of a picture held against the same layer of the truth.
struct LayerError {
    double reference_mean;  ///< over pixels and channels; finite values only
    double test_mean;
    compare::Comparison comparison;

    double mean_ratio() const { return test_mean / reference_mean; }
    double mse() const { return comparison.metrics.rmse * comparison.metrics.rmse; }
};

/// The errors of the whole picture and of its indirect light alone.
struct PictureErrors {
    LayerError radiance;
    LayerError indirect;
};

/// A model of ddgi with the constants it ran with.
struct ModelRun {
    std::string id;       ///< unique in the scene: [a-z0-9-]+
    std::string title;    ///< for readers
    std::string command;  ///< makes the same picture
    ddgi::DdgiOptions options;
    ddgi::DdgiResult result;  ///< converged
    double frame_ms;  ///< of a frame in motion: moved surfels, one probe update and the picture
    PictureErrors errors;
};

/// The path tracer at few samples a pixel, with another seed than the truth's.
struct PathTracerRun {
    int spp;
    double seconds;
    std::uint64_t rays;
    PictureErrors errors;
};

/// What calibration found, and what it took.
struct FitRun {
    compare::FitResult result;
    double seconds;
};

/// Everything measured of one scene at one frame.
struct SceneReport {
    std::string argument;  ///< as given on the command line
    std::string name;
    std::string description;
    std::string hash;  ///< SHA-1 of what `plumbline export` writes as JSON
    int frame;
    std::string truth_command;
    pathtracer::RenderResult truth;
    std::vector<ModelRun> models;
    std::vector<PathTracerRun> path_tracer;
    std::optional<FitRun> fit;
    std::vector<EffectReason> effects;
    std::vector<std::string> left_out;           ///< what was not measured, and why: one line each
    std::optional<AnimationErrors> animation{};  ///< none if nothing moves
    std::optional<Frontier> frontier{};
    std::vector<compare::EnergyAudit> audits{};  ///< of each model, with the constants as published
};

/// What measure() will take, in the unit of Stages.
double total_work(const Scene& scene, const Quality& quality);

/// Renders the truth and every model, fits, and compares. `argument` is what load_scene takes, and
/// `scene` what it gave, with the picture's size set.
/// Throws SceneError, UsageError.
SceneReport measure(const std::string& argument, const Scene& scene, int frame,
                    const Quality& quality, Stages& stages);

}  // namespace plumbline::reports
