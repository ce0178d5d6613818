// SPDX-License-Identifier: Apache-2.0
#include "ddgi/surfel_ends.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "scenes/wide.h"

namespace plumbline::ddgi {

void SurfelEnds::trace(const ProbeGrid& grid, const MotionMarker& marker, const Surfels& surfels,
                       std::span<const std::size_t> which) {
    which_ = which;
    rays_.count = 0;
    const auto per_probe = static_cast<std::size_t>(surfels.per_probe);
    std::size_t next_probe = 0;  // its first surfel
    glm::vec3 origin;
    std::uint32_t probe = 0;
    for (const std::size_t surfel : which) {
        if (surfel >= next_probe) {
            probe = static_cast<std::uint32_t>(surfel / per_probe);
            next_probe = (probe + 1) * per_probe;
            origin = probe_position(grid, probe);
        }
        probe_[rays_.count] = probe;
        const glm::vec3& direction = surfels.direction[surfel];
        rays_.push({origin, direction, marker.ray_length(direction)});
    }
    tracer_.intersect(rays_, BackFaces::Cull, Coherence::Incoherent, hits_);
    offset_positions();
    std::fill_n(hit_.begin(), which.size(), missed);
    for (std::size_t i = 0; i < hits_.count; ++i) hit_[hits_.ray[i]] = static_cast<std::int32_t>(i);
}

PLUMBLINE_WIDE void SurfelEnds::offset_positions() {
#pragma GCC ivdep
    for (std::size_t i = 0; i < hits_.count; ++i) {
        position_.set(i, offset_origin(hits_.position[i], hits_.position_error[i], hits_.n[i]));
    }
}

bool SurfelEnds::is_at(const Surfels& surfels, std::size_t i) const {
    std::optional<Hit> hit;
    if (hit_[i] != missed) hit = hits_[static_cast<std::size_t>(hit_[i])];
    return ddgi::is_at(surfels, tracer_.world(), which_[i], hit);
}

void SurfelEnds::put(Surfels& surfels, std::size_t i) const {
    const std::size_t surfel = which_[i];
    const World& world = tracer_.world();
    const bool emits = !surfels.emission.empty();
    if (hit_[i] == missed) {
        surfels.place[surfel] = {};
        surfels.light[surfel] = {};
        surfels.object[surfel] = -1;
        if (emits) {
            surfels.emission[surfel] = environment_radiance(world, surfels.direction[surfel]);
        }
        return;
    }
    const auto hit = static_cast<std::size_t>(hit_[i]);
    surfels.place[surfel] = {position_[hit], hits_.n[hit], hits_.t[hit]};
    surfels.object[surfel] = hits_.object[hit];
    surfels.light[surfel].albedo = hits_.albedo[hit];
    if (emits) {
        surfels.emission[surfel] =
            world.materials[static_cast<std::size_t>(hits_.material[hit])].emission;
    }
}

}  // namespace plumbline::ddgi
