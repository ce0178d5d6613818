// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "scenes/geometry.h"

namespace plumbline::ddgi {

/// Where the probes' rays met the scene, as a structure of arrays: the surfel of ray r of probe p
/// is at p * per_probe + r. Of a miss only `direction`, `distance` and
/// `emission` are meaningful.
struct Surfels {
    int per_probe = 0;
    std::vector<glm::vec3> direction;  ///< unit, of the probe's ray
    std::vector<float> distance;       ///< from the probe; infinite for a miss
    std::vector<glm::vec3> position;   ///< world space, off the surface by its rounding error
    std::vector<glm::vec3> n;          ///< unit normal on the side that was hit
    std::vector<int> object;           ///< index into World::objects; -1 for a miss
    std::vector<Spectrum> albedo;
    std::vector<Spectrum> emission;  ///< radiance, W m^-2 sr^-1; of a miss, the environment's
    std::vector<Spectrum> direct;    ///< irradiance from the lights, W m^-2
    /// Which probes around it a surfel sees, see seen_probes(); empty if nobody asks.
    std::vector<std::uint8_t> seen;
    /// Of each hit, the surfel whose light it shows, see SurfelCells; empty if each has its own.
    std::vector<std::uint32_t> source;

    std::size_t size() const { return distance.size(); }
    bool hit(std::size_t surfel) const { return std::isfinite(distance[surfel]); }
    /// Whose light a hit shows.
    std::size_t source_of(std::size_t surfel) const {
        return source.empty() ? surfel : source[surfel];
    }
    /// Whether light is measured at this surfel itself.
    bool own_light(std::size_t surfel) const {
        return hit(surfel) && source_of(surfel) == surfel;
    }

    void resize(std::size_t probes, int surfels_per_probe) {
        per_probe = surfels_per_probe;
        const std::size_t count = probes * static_cast<std::size_t>(surfels_per_probe);
        direction.resize(count);
        distance.resize(count, std::numeric_limits<float>::infinity());
        position.resize(count);
        n.resize(count);
        object.resize(count, -1);
        albedo.resize(count);
        emission.resize(count);
        direct.resize(count);
    }
};

}  // namespace plumbline::ddgi
