// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
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

    /// Takes in new surfels, which stay as they are until the next call; `cache` must live on.
    virtual void take_surfels(const SurfelCache& cache) = 0;
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
/// `set` overrides constants; `options` are for conserving. Throws UsageError for an unknown model
/// or constant, or a value out of range.
ModelSetup make_model(const std::string& name, const Scene& scene, const ProbeGrid& grid,
                      const std::map<std::string, double>& set, const ProbeOptions& options);

}  // namespace plumbline::ddgi
