// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ddgi/probe_options.h"
#include "ddgi/surfel_cache.h"

namespace plumbline::ddgi {

/// A surface point under the probes.
struct ReceiverPoint {
    glm::vec3 position;  ///< world space
    glm::vec3 n;         ///< unit normal on the side that is seen
    Spectrum albedo;
    std::uint8_t seen = all_probes;  ///< see seen_probes(); asked for with Visibility only
    glm::vec3 to_viewer{0.f};        ///< unit
};

/// A way to fill probes from surfels and to light surfaces from probes.
///
/// All probes' values are one flat buffer (see value_index); an update reads the last one and
/// writes the next, so its result does not depend on the order of probes. Immutable while
/// threads call probe_light.
class ProbeModel {
 public:
    virtual ~ProbeModel() = default;

    virtual RayPattern pattern(int surfels) const = 0;
    virtual Reach reach() const = 0;
    /// Whether pixels on edges get more samples; the published picture has four everywhere.
    virtual bool samples_edges() const { return true; }
    virtual ProbeWeights weights() const { return ProbeWeights::None; }
    /// Values a probe and channel, where probes have `surfels` rays.
    virtual std::size_t bins(int surfels) const = 0;

    /// Whether every update takes other rays: surfels are then placed afresh for each.
    virtual bool turns_rays() const { return false; }
    /// The rays of update number `update` of a model that turns them.
    virtual RayPattern turned_pattern(int surfels, int update) const;
    /// Whether updates that no longer change the values never will again.
    virtual bool settles() const { return true; }
    /// Updates that a still takes, of a model that cannot converge.
    virtual std::optional<int> updates_of_still() const { return std::nullopt; }
    /// Whether an update is linear in the values, and so has a spectral radius.
    virtual bool is_linear() const { return true; }

    /// Takes in the world whose surfels take_surfels() is about to bring. `motion` leads here from
    /// that of the last call; null says that anything may have changed.
    virtual void take_world(const RayTracer& tracer, const SurfelCache& cache,
                            const Motion* motion);
    /// Takes in new surfels, which stay as they are until the next call; `cache` must live on.
    virtual void take_surfels(const SurfelCache& cache) = 0;
    /// Says that an update of the volume follows, to a model that itself remembers the last ones.
    virtual void begin_update() {}
    /// One update of all probes.
    virtual void update(std::span<const float> previous, std::span<float> next) const = 0;

    /// Radiance that the probes add to a pixel that sees `point`.
    virtual Spectrum probe_light(std::span<const float> values,
                                 const ReceiverPoint& point) const = 0;
    /// The part of it that was scattered only once, at `point` itself: light of the environment
    /// and of surfaces that emit. Direct light, though probes brought it.
    virtual Spectrum emitted_light(const ReceiverPoint& point) const;
    /// Radiance that the model adds everywhere, whatever the light.
    virtual Spectrum ambient(const Spectrum& albedo) const;

    /// The constants as used, by their published names; empty if the model has none.
    virtual std::map<std::string, double> constants() const;
};

/// A model, and what a user should know of how it was set up: one line each.
struct ModelSetup {
    std::unique_ptr<ProbeModel> model;
    std::vector<std::string> notes;
};

/// The models by name, best first. There is one more, `steps`, for studies: see Steps.
std::vector<std::string> model_names();

/// Makes a model for a scene whose probes stand on `grid`, which may differ from the scene's own.
/// `set` overrides constants; `options` are for conserving, and `shifted` for irradiance too.
/// Throws UsageError for an unknown model or constant, or a value out of range.
ModelSetup make_model(const std::string& name, const Scene& scene, const ProbeGrid& grid,
                      const std::map<std::string, double>& set, const ProbeOptions& options);

}  // namespace plumbline::ddgi
