// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scenes/world.h"
#include "scenes/write_json.h"

namespace plumbline {

/// What a scene holds at a frame: size, objects, materials, lights, camera, probes, the effects
/// that are simulated and those that are not, each with the reason, and warnings.
OrderedJson inspection(const Scene& scene, int frame);

/// The effects that are simulated (`simulated`), or those that are not, each with the reason.
OrderedJson effects_json(const Scene& scene, bool simulated);

/// What may spoil a picture without being wrong: triangles without area, positions that overflow,
/// coordinates so large that a float cannot resolve the smallest object there. One line each.
std::vector<std::string> scene_warnings(const Scene& scene, const World& world);

}  // namespace plumbline
