// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "pathtracer/path_options.h"
#include "pathtracer/walks.h"
#include "scenes/camera_rays.h"

namespace plumbline::pathtracer {

// What happens to all paths alike, as loops over lanes; at the surfaces that they hit, path i at
// hits[i].

/// Draws where in the pixel whose top left corner is `pixel` each of `rays.count` paths begins,
/// and sets the camera's rays through there.
void aim_camera(const CameraRays& camera, const glm::vec2& pixel, SamplerLanes& samplers,
                RayLanes& rays);

/// Where rays leave the surfaces.
void start_rays(const HitLanes& hits, Lanes3& origin);

/// L[i] becomes the radiance that `light` brings path i unless something hides it.
void shine(EvenLight light, const HitLanes& hits, const Lanes3& beta, Lanes3& L);

/// lit[i] becomes whether L[i] is anything.
void find_lit(std::size_t count, const Lanes3& L, Lanes<std::int32_t>& lit);

/// seen[i] becomes whether hidden[i] is 0.
void find_seen(std::size_t count, const Lanes<std::int32_t>& hidden, Lanes<std::int32_t>& seen);

/// Draws each path's next direction, and takes the albedo into its throughput.
void scatter(const HitLanes& hits, WalkLanes& walks);

/// alive[i] becomes whether path i still carries anything.
void find_alive(std::size_t count, const WalkLanes& walks, Lanes<std::int32_t>& alive);

/// Lets roulette choose which paths live on too; their throughput then makes up for those ended.
void play_roulette(const PathOptions& options, std::size_t count, WalkLanes& walks,
                   Lanes<std::int32_t>& alive);

}  // namespace plumbline::pathtracer
