// SPDX-License-Identifier: Apache-2.0
#include "ddgi/angular_bins.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace plumbline::ddgi {
namespace {

constexpr std::size_t most_cells = 128;

Spectrum looked_up(const ProbeNeighbours& around, std::span<const float> response,
                   std::span<const float> values) {
    const auto [r, g, b] = look_up<float>(around, response, values);
    return {r, g, b};
}

/// The mean over z in [a, b] of sqrt(1 - z^2), which is the mean distance from the axis.
double mean_radius(double a, double b) {
    const auto integral = [](double z) { return (z * std::sqrt(1. - z * z) + std::asin(z)) / 2.; };
    return (integral(b) - integral(a)) / (b - a);
}

}  // namespace

void OctantStorage::take_surfels(const SurfelCache& cache) {
    const Surfels& surfels = cache.surfels();
    cosines_.resize(surfels.size());
    tbb::parallel_for(std::size_t{0}, surfels.size(), [&](std::size_t i) {
        if (surfels.hit(i) && cache.replaced(i)) cosines_[i] = octant_cosines(surfels.place[i].n);
    });
}

void OctantStorage::store(std::span<const RayLight> rays, std::span<float> values) const {
    const std::size_t per_octant = rays.size() / octant_count;
    for (std::size_t d = 0; d < octant_count; ++d) {
        Spectrum sum(0.f);
        for (const RayLight& ray : rays.subspan(d * per_octant, per_octant)) sum += ray.radiance;
        for (std::size_t c = 0; c < 3; ++c)
            values[value_index(0, c, d, octant_count)] =
                sum[static_cast<int>(c)] / static_cast<float>(per_octant);
    }
}

Spectrum OctantStorage::irradiance(const ProbeNeighbours& around, std::span<const float> values,
                                   const glm::vec3& n) const {
    return looked_up(around, octant_cosines(n), values);
}

Spectrum OctantStorage::surfel_irradiance(const ProbeNeighbours& around,
                                          std::span<const float> values, const Surfels&,
                                          std::size_t surfel) const {
    return looked_up(around, cosines_[surfel], values);
}

EqualStorage::EqualStorage(int layers, int sectors) : layers_(layers), sectors_(sectors) {
    const double half_sector = glm::pi<double>() / sectors;
    const double chord = std::sin(half_sector) / half_sector;
    for (int layer = 0; layer < layers; ++layer) {
        const double lower = 2. * layer / layers - 1.;
        const double upper = 2. * (layer + 1) / layers - 1.;
        const double radius = chord * mean_radius(lower, upper);
        for (int sector = 0; sector < sectors; ++sector) {
            const double azimuth = half_sector * (2 * sector + 1);
            centres_.emplace_back(radius * std::cos(azimuth), (lower + upper) / 2.,
                                  radius * std::sin(azimuth));
        }
    }
}

std::size_t EqualStorage::cell_of(const glm::vec3& w) const {
    const float turn = std::atan2(w.z, w.x) / (2.f * glm::pi<float>());
    const int layer = std::clamp(static_cast<int>((w.y + 1.f) / 2.f * static_cast<float>(layers_)),
                                 0, layers_ - 1);
    const int sector = std::clamp(
        static_cast<int>((turn < 0.f ? turn + 1.f : turn) * static_cast<float>(sectors_)), 0,
        sectors_ - 1);
    return std::size_t(layer) * std::size_t(sectors_) + std::size_t(sector);
}

void EqualStorage::store(std::span<const RayLight> rays, std::span<float> values) const {
    std::array<Spectrum, most_cells> sum{};
    std::array<float, most_cells> count{};
    for (const RayLight& ray : rays) {
        const std::size_t cell = cell_of(ray.direction);
        sum[cell] += ray.radiance;
        count[cell] += 1.f;
    }
    for (std::size_t cell = 0; cell < bins(); ++cell) {
        const auto nearness = [&](const RayLight& ray) {
            return glm::dot(ray.direction, centres_[cell]);
        };
        const Spectrum mean = count[cell] > 0.f
                                  ? sum[cell] / count[cell]
                                  : std::ranges::max_element(rays, {}, nearness)->radiance;
        for (std::size_t c = 0; c < 3; ++c)
            values[value_index(0, c, cell, bins())] = mean[static_cast<int>(c)];
    }
}

Spectrum EqualStorage::irradiance(const ProbeNeighbours& around, std::span<const float> values,
                                  const glm::vec3& n) const {
    std::array<float, most_cells> response{};
    float sum = 0.f;
    for (std::size_t cell = 0; cell < bins(); ++cell) {
        response[cell] = std::max(0.f, glm::dot(n, centres_[cell]));
        sum += response[cell];
    }
    return looked_up(around, std::span(response).first(bins()), values) * (glm::pi<float>() / sum);
}

}  // namespace plumbline::ddgi
