// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "scenes/ray_tracer.h"

namespace plumbline::ddgi {

/// Irradiance from the lights, W m^-2, and the shadow rays that it took.
struct DirectLight {
    Spectrum irradiance{0.f};
    std::uint32_t shadow_rays = 0;
};

/// At `position`, just off a surface with unit normal `n`, with `rays` shadow rays a light: the
/// sum over lights of E_light max(n . l, 0) times the share of rays that arrive.
///
/// A light without size is seen from a point whole or not at all, so its rays are all the same; one
/// far away takes a single ray. Rays to a light with a radius are spread evenly over the solid
/// angle that it fills, without bias at any number of rays: the more rays, the smoother its soft
/// shadow.
DirectLight direct_light(const RayTracer& tracer, const glm::vec3& position, const glm::vec3& n,
                         int rays = 1);

/// The same for many points at once, whose rays are traced together: at[i] becomes
/// direct_light(tracer, positions[i], n[i]).
void direct_light(const RayTracer& tracer, std::span<const glm::vec3> positions,
                  std::span<const glm::vec3> n, std::span<DirectLight> at);

}  // namespace plumbline::ddgi
