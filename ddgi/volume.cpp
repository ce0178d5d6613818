// SPDX-License-Identifier: Apache-2.0
#include "ddgi/volume.h"

#include "ddgi/change.h"
#include "ddgi/seen_probes.h"
#include "ddgi/stopwatch.h"
#include "scenes/errors.h"

namespace plumbline::ddgi {

/// A frame's world and the rays into it.
struct ProbeVolume::Stage {
    World world;
    RayTracer tracer;

    explicit Stage(World world_at_frame) : world(std::move(world_at_frame)), tracer(world) {}
};

ProbeGrid grid_for(const Scene& scene, const DdgiOptions& options) {
    const ProbeGrid grid = probe_grid(scene);
    return options.spacing ? with_spacing(grid, *options.spacing) : grid;
}

ProbeVolume::ProbeVolume(const Scene& scene, const DdgiOptions& options)
    : scene_(scene),
      caching_(options.cache),
      surfels_(options.surfels),
      share_(options.share),
      grid_(grid_for(scene, options)),
      setup_(make_model(options.model, scene, grid_, options.set, options.probes)),
      bins_(setup_.model->bins(options.surfels)),
      cache_(grid_, setup_.model->pattern(options.surfels), setup_.model->reach(),
             setup_.model->weights(), options.budget, options.share),
      values_(probe_count(grid_) * 3 * bins_, 0.f),
      next_(values_.size()) {
    if (options.budget && setup_.model->turns_rays()) {
        throw UsageError("--budget",
                         "the rays of this model turn, so that all are placed at every update",
                         "leave --budget out, or give --set turnedRays=0");
    }
}

ProbeVolume::~ProbeVolume() = default;

ReceiverPoint ProbeVolume::receiver(const glm::vec3& position, const glm::vec3& n,
                                    const Spectrum& albedo) const {
    ReceiverPoint point{position, n, albedo};
    if (model().weights() == ProbeWeights::Visibility)
        point.seen = seen_probes(tracer(), grid_, position, n);
    return point;
}

const RayTracer& ProbeVolume::tracer() const { return stage_->tracer; }

void ProbeVolume::move_to(int frame) {
    figures_ = {};
    const Stopwatch watch;
    World world = world_at(scene_, frame);
    const bool first = stage_ == nullptr;
    const Motion motion = first ? Motion{} : motion_between(stage_->world, world);
    const bool changed = first || !motion.none();
    if (changed) stage_ = std::make_unique<Stage>(std::move(world));
    figures_.bvh_ms = watch.ms();

    if (setup_.model->turns_rays()) {
        turn_rays();
        return;
    }
    const bool due = changed || !caching_ || cache_.waiting() > 0;
    const bool afresh = first || !caching_;
    if (afresh) {
        cache_.rebuild(stage_->tracer);
    } else {
        cache_.refresh(stage_->tracer, motion);
    }
    note_surfels();
    if (due) take_surfels(afresh ? nullptr : &motion);
}

void ProbeVolume::note(const StepTimes& times) {
    figures_.steps += times;
    figures_.place_ms = figures_.steps.placing();
    figures_.light_ms = figures_.steps.lighting();
}

/// Hands the surfels to the model. `motion` as for ProbeModel::take_world().
void ProbeVolume::take_surfels(const Motion* motion) {
    const Stopwatch watch;
    setup_.model->take_world(stage_->tracer, cache_, motion);
    setup_.model->take_surfels(cache_);
    settled_ = false;
    note({.take = watch.ms()});
}

/// Re-places the surfels whose turn it is, in a world at rest.
void ProbeVolume::serve_waiting() {
    const Motion rest = motion_between(stage_->world, stage_->world);
    cache_.refresh(stage_->tracer, rest);
    note_surfels();
    take_surfels(&rest);
}

/// Adds what the cache's last call did to the frame's figures.
void ProbeVolume::note_surfels() {
    note(cache_.figures().steps);
    figures_.replaced += cache_.figures().replaced;
    figures_.surfel_shadow_rays += cache_.figures().shadow_rays;
    figures_.shadow_rays = figures_.surfel_shadow_rays;
    figures_.probes = probe_count(grid_);
    figures_.surfels = cache_.surfels().size();
    figures_.surfels_hit = cache_.hits();
    figures_.surfels_lit = cache_.lit();
    figures_.surfels_waiting = cache_.waiting();
    figures_.oldest_wait = cache_.oldest_wait();
}

void ProbeVolume::turn_rays() {
    ProbeModel& model = *setup_.model;
    cache_ = SurfelCache(grid_, model.turned_pattern(surfels_, turns_++), model.reach(),
                         model.weights(), std::nullopt, share_);
    cache_.rebuild(stage_->tracer);
    note_surfels();
    take_surfels(nullptr);
}

void ProbeVolume::update() {
    ++figures_.updates;
    // The first update of a frame takes what move_to() placed.
    if (figures_.updates > 1 && cache_.waiting() > 0) serve_waiting();
    if (settled_) {
        figures_.relative_change = 0.;
        figures_.converged = true;
        return;
    }
    if (setup_.model->turns_rays() && figures_.updates > 1) turn_rays();
    const Stopwatch watch;
    setup_.model->begin_update();
    setup_.model->update(values_, next_);
    const Change change = change_between(values_, next_, 3 * bins_);
    values_.swap(next_);
    settled_ = change.none && setup_.model->settles();
    figures_.relative_change = change.relative;
    figures_.converged = change.relative < convergence_threshold && cache_.waiting() == 0;
    note({.update = watch.ms()});
}

void ProbeVolume::converge() {
    if (const auto updates = setup_.model->updates_of_still()) {
        while (figures_.updates < *updates) update();
        return;
    }
    while (!figures_.converged && figures_.updates < most_updates) update();
}

}  // namespace plumbline::ddgi
