// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenes/geometry.h"

namespace plumbline {

/// Light from all around as an equirectangular picture of even pixels: its rows go from straight up
/// (+y) to straight down, its columns once around, -z in the middle and +x a quarter to the right.
struct Panorama {
    std::filesystem::path file;  ///< where it was read from
    int width = 0;
    int height = 0;
    std::vector<Spectrum> radiance;  ///< W m^-2 sr^-1, row by row from the top left

    /// The pixel that the unit vector `direction` falls on.
    std::size_t pixel(const glm::vec3& direction) const;
    /// The unit vector to a place in the picture, both coordinates in [0,1] from the top left.
    static glm::vec3 direction(const glm::dvec2& place);
    /// Files may move: what counts is what is seen.
    bool operator==(const Panorama& other) const;
};

/// Reads R, G and B of any picture that read_image() reads. Throws SceneError if a value is
/// negative or not finite, and ImageError.
Panorama read_panorama(const std::filesystem::path& file);

}  // namespace plumbline
