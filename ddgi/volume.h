// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "ddgi/model.h"
#include "ddgi/render.h"

namespace plumbline::ddgi {

/// The scene's grid, with the spacing that the options ask for. Throws UsageError.
ProbeGrid grid_for(const Scene& scene, const DdgiOptions& options);

/// A scene's probes as they live from frame to frame.
class ProbeVolume {
 public:
    /// `scene` must outlive it. Throws UsageError for options that name what does not exist.
    ProbeVolume(const Scene& scene, const DdgiOptions& options);
    ~ProbeVolume();

    /// Moves the geometry to `frame` and re-places and lights the surfels that this touches.
    /// Starts the figures of a new frame.
    void move_to(int frame);

    /// One update of all probes, skipped if the last one changed no bit and no surfel has changed
    /// since: it would change none either. With a budget, each update of a frame has its own.
    void update();

    /// Updates until FrameFigures::converged, `most_updates` at most; a model that cannot converge,
    /// ProbeModel::updates_of_still() times.
    void converge();

    /// A surface point, `position` just off it, with the probes that the model asks for.
    ReceiverPoint receiver(const glm::vec3& position, const glm::vec3& n,
                           const Spectrum& albedo) const;

    const RayTracer& tracer() const;
    const ProbeModel& model() const { return *setup_.model; }
    std::span<const float> values() const { return values_; }
    const SurfelCache& cache() const { return cache_; }
    const FrameFigures& figures() const { return figures_; }
    const std::vector<std::string>& notes() const { return setup_.notes; }

 private:
    struct Stage;

    void turn_rays();
    void note(const StepTimes& times);
    void note_surfels();
    void take_surfels(const Motion* motion);
    void serve_waiting();

    const Scene& scene_;
    bool caching_;
    int surfels_;  ///< a probe
    double share_;
    ProbeGrid grid_;
    ModelSetup setup_;
    std::size_t bins_;  ///< values a probe and channel
    SurfelCache cache_;
    std::unique_ptr<Stage> stage_;  ///< the world of the last move_to()
    std::vector<float> values_;     ///< what the probes hold, see value_index()
    std::vector<float> next_;       ///< what an update writes
    bool settled_ = false;          ///< another update would change no bit
    int turns_ = 0;                 ///< of the rays so far, if the model turns them
    FrameFigures figures_;
};

}  // namespace plumbline::ddgi
