// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "scenes/geometry.h"

namespace plumbline::ddgi {

/// Where a ray of a probe ends.
struct alignas(32) SurfelPlace {
    glm::vec3 position{0.f};  ///< world space, off the surface by its rounding error
    glm::vec3 n{0.f};         ///< unit normal on the side that was hit
    float distance =
        std::numeric_limits<float>::infinity();  ///< from the probe; of a miss infinite

    bool operator==(const SurfelPlace&) const = default;
};

/// What a surfel scatters: radiance albedo / pi times all that falls on it. Both are 0 of a miss.
struct SurfelLight {
    Spectrum albedo{0.f};
    Spectrum direct{0.f};  ///< irradiance from the lights, W m^-2

    bool operator==(const SurfelLight&) const = default;
};

/// Where the probes' rays met the scene: the surfel of ray r of probe p is at p * per_probe + r.
struct Surfels {
    int per_probe = 0;
    std::vector<glm::vec3> direction;  ///< unit, of the probe's ray
    std::vector<SurfelPlace> place;
    std::vector<int> object;  ///< index into World::objects; -1 for a miss
    std::vector<SurfelLight> light;
    /// Radiance, W m^-2 sr^-1; of a miss, the environment's. Empty if nothing emits.
    std::vector<Spectrum> emission;
    /// Which probes around it a surfel sees, see seen_probes(); empty if nobody asks.
    std::vector<std::uint8_t> seen;
    /// Of each hit, the surfel whose light it shows, see SurfelCells; empty if each has its own.
    std::vector<std::uint32_t> source;

    std::size_t size() const { return place.size(); }
    std::size_t probes() const { return size() / static_cast<std::size_t>(per_probe); }
    bool hit(std::size_t surfel) const { return std::isfinite(place[surfel].distance); }
    Spectrum emission_of(std::size_t surfel) const {
        return emission.empty() ? Spectrum(0.f) : emission[surfel];
    }
    /// Whose light a hit shows.
    std::size_t source_of(std::size_t surfel) const {
        return source.empty() ? surfel : source[surfel];
    }
    /// Whether light is measured at this surfel itself.
    bool own_light(std::size_t surfel) const { return hit(surfel) && source_of(surfel) == surfel; }

    void resize(std::size_t probes, int surfels_per_probe) {
        per_probe = surfels_per_probe;
        const std::size_t count = probes * static_cast<std::size_t>(surfels_per_probe);
        direction.resize(count);
        place.resize(count);
        object.resize(count, -1);
        light.resize(count);
    }
};

}  // namespace plumbline::ddgi
