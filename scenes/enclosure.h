// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "scenes/scene.h"

namespace plumbline {

/// Whether it is proven that no path from the camera leaves the scene, and why or why not, in plain
/// words.
struct Enclosure {
    bool proven;
    std::string why;
};

/// Looks for a closed body around the camera among the surfaces that never move: an inward sphere,
/// or connected triangles each of whose edges is shared, corner by corner to the bit, with one that
/// runs along it the other way.
///
/// The proof: let w(x) be how often the body winds around x, counted +1 where its front faces x. On
/// a ray from x to infinity, w(x) is the number of fronts met less the number of backs. If w >= 1
/// at the camera, each of its rays meets a front. Up to there it passes only backs of the body,
/// each of which raises w, so that w >= 1 where the ray ends; and so on from there, since scattered
/// rays pass nothing. Only ray origins that rounding sets beyond a surface are outside the proof.
/// Surfaces that are not of the body, or move, can end rays sooner, but let none out.
///
/// w is the sum of the solid angles of the triangles over 4 pi [van Oosterom and Strackee 1983].
/// Time n log n in triangles; scenes of more than a million are not looked into.
Enclosure enclosure(const Scene& scene);

}  // namespace plumbline
