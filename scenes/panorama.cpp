// SPDX-License-Identifier: Apache-2.0
#include "scenes/panorama.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "scenes/errors.h"
#include "scenes/image.h"

namespace plumbline {

std::size_t Panorama::pixel(const glm::vec3& d) const {
    const double u = .5 + std::atan2(double(d.x), -double(d.z)) / glm::two_pi<double>();
    const double v = std::acos(glm::clamp(double(d.y), -1., 1.)) / glm::pi<double>();
    const int x = std::clamp(static_cast<int>(u * width), 0, width - 1);
    const int y = std::clamp(static_cast<int>(v * height), 0, height - 1);
    return std::size_t(y) * std::size_t(width) + std::size_t(x);
}

glm::vec3 Panorama::direction(const glm::dvec2& place) {
    const double phi = (place.x - .5) * glm::two_pi<double>();
    const double theta = place.y * glm::pi<double>();
    return glm::vec3(glm::dvec3(std::sin(theta) * std::sin(phi), std::cos(theta),
                                -std::sin(theta) * std::cos(phi)));
}

bool Panorama::operator==(const Panorama& other) const {
    return width == other.width && height == other.height && radiance == other.radiance;
}

Panorama read_panorama(const std::filesystem::path& file) {
    const Image image = read_image(file);
    Panorama panorama{std::filesystem::absolute(file), image.width(), image.height(), {}};
    const auto rgb = image.layer("");
    panorama.radiance.resize(image.pixels());
    for (std::size_t i = 0; i < image.pixels(); ++i) {
        const Spectrum L(rgb[0][i], rgb[1][i], rgb[2][i]);
        // The negation also catches NaN.
        if (!(min_component(L) >= 0.f && std::isfinite(L.r + L.g + L.b))) {
            const auto width = std::size_t(image.width());
            throw SceneError(
                file.string(),
                fmt::format("its pixel ({}, {}) is negative or not finite", i % width, i / width),
                "light is 0 or more in every pixel");
        }
        panorama.radiance[i] = L;
    }
    return panorama;
}

}  // namespace plumbline
