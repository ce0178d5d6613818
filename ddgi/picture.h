// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "ddgi/volume.h"
#include "scenes/image.h"

namespace plumbline::ddgi {

constexpr int samples_per_pixel = 4;
/// Of a pixel whose samples meet unlike surfaces, if that is asked for.
constexpr int samples_on_edges = 16;

/// Where the samples of pixel (x, y) lie, in pixels from the top left: half a pixel from its
/// centre to each side [Dellson 2023, section 4.1.4].
std::array<glm::vec2, samples_per_pixel> pixel_samples(int x, int y);

/// A finer set within the pixel, even in both coordinates: a 16-point Hammersley set.
std::array<glm::vec2, samples_on_edges> edge_samples(int x, int y);

struct PictureOptions {
    int shadow_rays = 1;  ///< a sample and light
    /// Pixels whose samples differ in object or normal take edge_samples() instead.
    bool sample_edges = false;
};

/// As `options` ask, or as the model samples edges by itself.
PictureOptions picture_options(const DdgiOptions& options, const ProbeModel& model);

/// A picture and the shadow rays that it took.
struct Picture {
    Image image;
    std::uint64_t shadow_rays;
};

/// The view of a scene's camera under direct light and, unless `volume` is null, its probes'
/// light, at pixel_samples(), and at edge_samples() where these are asked for.
///
/// Layers: radiance = direct + indirect + ambient; albedo, normal and depth (along the view axis)
/// are means over the samples that meet a surface, 0 where none does; object is what the ray
/// through the pixel's centre meets, -1 for nothing. indirect and ambient need a volume and a
/// model that has them. A sample that meets nothing shows the environment, as direct light.
Picture take_picture(const RayTracer& tracer, const ProbeModel& model, const ProbeVolume* volume,
                     const PictureOptions& options);

}  // namespace plumbline::ddgi
