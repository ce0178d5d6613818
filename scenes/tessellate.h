// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenes/scene.h"

namespace plumbline {

/// The eight corners and twelve triangles of a box.
Mesh mesh_of(const Box& box);
/// The four corners and two triangles of a quad.
Mesh mesh_of(const Quad& quad);
/// A sphere as parallels and meridians, its vertices on the sphere: for programs that only know
/// meshes. The renderers use the exact sphere.
Mesh mesh_of(const Sphere& sphere);

}  // namespace plumbline
