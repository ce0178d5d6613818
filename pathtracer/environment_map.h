// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scenes/world.h"

namespace plumbline::pathtracer {

/// Chooses directions to the picture of a world's environment in proportion to the light that they
/// bring: pixels by their luminance times solid angle, from a table of the rows and one of each
/// row's pixels, and evenly within a pixel [Pharr et al. 2023, section 12.5.2].
class EnvironmentMap {
 public:
    /// `world`, which must outlive it, has a picture.
    explicit EnvironmentMap(const World& world);

    struct Sample {
        glm::vec3 wi;  ///< unit direction to the environment
        Spectrum L;    ///< its radiance
        float pdf;     ///< per unit of solid angle; 0 if the picture is black
    };
    Sample sample(const glm::vec2& u) const;

    /// The density of sample() by solid angle in the unit direction `wi`.
    float pdf(const glm::vec3& wi) const;

 private:
    std::size_t pixel(std::size_t row, std::size_t column) const { return row * width_ + column; }
    /// Solid angle of a pixel of this row.
    double solid_angle(std::size_t row) const;

    const World& world_;
    const Panorama& panorama_;
    std::size_t width_, height_;
    std::vector<double> rows_;     ///< cumulative weights, height + 1
    std::vector<double> columns_;  ///< for each row, cumulative weights, width + 1
};

}  // namespace plumbline::pathtracer
