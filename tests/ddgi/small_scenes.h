// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ddgi/probe_options.h"
#include "ddgi/surfels.h"
#include "scenes/image.h"
#include "scenes/scene.h"

namespace plumbline::ddgi {

/// A closed cubic room [-1,1]^3 of one material, seen from inside, with a grid of 4^3 probes
/// inside it and nothing that gives light but `emission`.
Scene closed_room(const Spectrum& albedo, const Spectrum& emission);

/// The inside of a sphere of radius 2 with a point light at `light`, of intensity 1.
Scene integrating_sphere(float albedo, const glm::vec3& light);

/// The closed room with walls of unlike colours, a point light, and a block that turns and drifts
/// in frames 2 to 6 of 10. The thesis's constants are set.
Scene room_with_moving_block();

/// Each storage, each kind of weights, and the default's choices left out one by one.
std::vector<ProbeOptions> all_probe_options();

/// The mean of a layer over all pixels and channels.
double mean(const Image& image, const std::string& layer);

/// Whether all channels of both have the same names and the same bytes.
bool same_bytes(const Image& a, const Image& b);

/// Whether all that is meaningful of the surfels of both has the same bits.
bool same_surfels(const Surfels& a, const Surfels& b);

}  // namespace plumbline::ddgi
