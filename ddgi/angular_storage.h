// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>

#include "ddgi/look_up.h"
#include "ddgi/octahedral.h"
#include "ddgi/probe_options.h"
#include "ddgi/surfel_cache.h"

namespace plumbline::ddgi {

/// How a probe keeps the light of its rays by direction, and gives it back to surfaces.
///
/// All kinds are linear, and conserve energy at the look-up: where every ray brings radiance L,
/// E(n) = pi L for every normal n. Immutable while threads call store and irradiance.
class AngularStorage {
 public:
    virtual ~AngularStorage() = default;

    virtual RayPattern pattern(int surfels, bool shifted) const {
        return sphere_pattern(surfels, shifted);
    }
    /// Values a probe and channel; a multiple of bins_at_once.
    virtual std::size_t bins() const = 0;
    /// Takes in where the rays of all probes ended.
    virtual void take_surfels(const SurfelCache&) {}
    /// What a probe keeps of its rays, channel by channel (see value_index).
    virtual void store(std::span<const RayLight> rays, std::span<float> values) const = 0;
    /// E on a surface of unit normal `n`, W m^-2, from the probes around it.
    virtual Spectrum irradiance(const ProbeNeighbours& around, std::span<const float> values,
                                const glm::vec3& n) const = 0;
    /// The same at a surfel of those taken in.
    virtual Spectrum surfel_irradiance(const ProbeNeighbours& around, std::span<const float> values,
                                       const Surfels& surfels, std::size_t surfel) const {
        return irradiance(around, values, surfels.place[surfel].n);
    }
};

/// Every storage but Storage::Rays, for probes on `grid`.
std::unique_ptr<AngularStorage> make_storage(Storage storage, const ProbeGrid& grid);

}  // namespace plumbline::ddgi
