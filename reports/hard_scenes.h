// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "scenes/scene.h"

namespace plumbline::reports {

/// The size of a hard case's picture: small, since each pixel is a test of its own.
inline constexpr int hard_width = 24;
inline constexpr int hard_height = 16;

int add_material(Scene& scene, const Spectrum& albedo, const Spectrum& emission = Spectrum(0.f));
void add_object(Scene& scene, const std::string& name, const decltype(Object::shape)& shape);
/// An object of the scene's own triangles, all of one material.
void add_mesh(Scene& scene, const std::string& name, std::vector<glm::vec3> positions,
              std::vector<glm::uvec3> triangles, int material);
void add_point_light(Scene& scene, const glm::vec3& position, const Spectrum& intensity);

/// A quad around `center` whose front looks along +-`axis`, with edges of 2 `half`.
Quad wall(int axis, float facing, const glm::vec3& center, const glm::vec3& half, int material);

/// The room [-1,1]^3 of one material, seen from inside, with 4 x 4 x 4 probes and no light.
Scene closed_room(const Spectrum& albedo, const Spectrum& emission = Spectrum(0.f));

/// A closed room that glows with 1 and reflects 1/2: whatever stands in it, if of the same
/// material, radiance is 1 + 1/2 + 1/4 + ... = 2 everywhere and in every direction. Its
/// materials[0].
Scene furnace();
inline constexpr double furnace_radiance = 2.;
/// The same after `bounces` indirect bounces, in every sample: the glow of what is seen, of what
/// lights it directly and of one surface more for each bounce, 2 - 2^-(bounces + 1).
double furnace_series(int bounces);

/// A closed room of grey walls with a lamp and a block.
Scene lit_room();

/// `scene` times `scale`, then moved by `shift`: camera, probes and lights with it, and the
/// intensity of inverse-square lights times the squared scale, so that radiance stays.
Scene scaled_and_moved(Scene scene, float scale, const glm::vec3& shift);

}  // namespace plumbline::reports
