// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

namespace plumbline::compare {

/// CIE XYZ of linear sRGB with D65 white, with the authors' matrix [Andersson et al. 2020].
glm::vec3 xyz_from_linear_rgb(const glm::vec3& rgb);
glm::vec3 linear_rgb_from_xyz(const glm::vec3& xyz);

/// The linear opponent space in which contrast sensitivity is applied: Y in [-16, 100].
glm::vec3 ycxcz_from_linear_rgb(const glm::vec3& rgb);
glm::vec3 linear_rgb_from_ycxcz(const glm::vec3& ycxcz);

/// CIELAB with a* and b* scaled by L*/100: chroma is seen the less the darker it is
/// [Hunt 1952, as used by Andersson et al. 2020].
glm::vec3 hunt_lab_from_linear_rgb(const glm::vec3& rgb);

/// The distance for large colour differences [Abasi et al. 2020].
float hyab(const glm::vec3& a, const glm::vec3& b);

/// ACES filmic curve as rational polynomial [Narkowicz 2015], its pre-exposure of 0.6 cancelled;
/// 2.51/2.43 at infinity.
float tone_map_aces(float x);
/// The x > 0 that tone_map_aces() takes to y, 0 < y < 1.
double inverse_tone_map_aces(double y);

}  // namespace plumbline::compare
