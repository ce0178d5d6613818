// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "scenes/scene.h"

namespace plumbline {

/// The largest picture, frame count and probe count that a scene may ask for.
constexpr int max_image_side = 16384;
constexpr int max_pixels = 1 << 28;
constexpr int max_frames = 10'000'000;
constexpr int max_probes = 100'000'000;

/// How far from the origin a scene may reach, in its unit of length. Embree's test of a triangle
/// multiplies three lengths (a corner's place, and the sides in the normal), which must stay within
/// a float; beyond 1.8e18 it stops the program.
constexpr float farthest_place = 1e12f;

/// How far from the origin a scene with any shape reaches at least. Where a triangle's normal, the
/// product of two sides, is below 1e-18 along a ray, Embree puts the hit to the first corner: with
/// sides of 1e-9 it nearly always is.
constexpr float nearest_reach = 1e-6f;

/// Objects from this size on, and triangles with such sides, are met where they are, unless nearly
/// edge-on. What is smaller has no size that counts.
constexpr float smallest_size = 1e-8f;

/// Tells where a part of a scene stands in its file, for messages: `list` is "objects",
/// "materials", "meshes", "lights", "camera", "probes", ...; `index` counts in that list of the
/// Scene; `member` is a path below it such as "sphere/radius", or empty.
using PlaceOf =
    std::function<std::string(std::string_view list, std::size_t index, std::string_view member)>;

/// Refuses a scene that makes no sense, whichever file it came from: indices that do not exist,
/// numbers that are not finite or out of range, names that stand twice. Linear in its size.
/// Throws SceneError at the place that `place_of` tells.
void check_scene(const Scene& scene, const PlaceOf& place_of);

}  // namespace plumbline
