// SPDX-License-Identifier: Apache-2.0
#include "ddgi/harmonics.h"

#include <algorithm>
#include <array>
#include <glm/gtc/constants.hpp>

namespace plumbline::ddgi {
namespace {

constexpr std::size_t most_bins = 16;  // nine, filled up to vectors

/// A_l of each coefficient [Ramamoorthi and Hanrahan 2001, eq. 8].
constexpr float pi = glm::pi<float>();
constexpr std::array<float, 9> clamped_cosine{
    pi, 2.f * pi / 3, 2.f * pi / 3, 2.f * pi / 3, pi / 4, pi / 4, pi / 4, pi / 4, pi / 4};

}  // namespace

std::array<float, 9> harmonics(const glm::vec3& w) {
    constexpr float y0 = .282094792f;   // sqrt(1 / (4 pi))
    constexpr float y1 = .488602512f;   // sqrt(3 / (4 pi))
    constexpr float y2 = 1.092548431f;  // sqrt(15 / (4 pi))
    constexpr float y20 = .315391565f;  // sqrt(5 / (16 pi))
    constexpr float y22 = .546274215f;  // sqrt(15 / (16 pi))
    return {y0,
            y1 * w.y,
            y1 * w.z,
            y1 * w.x,
            y2 * w.x * w.y,
            y2 * w.y * w.z,
            y20 * (3.f * w.z * w.z - 1.f),
            y2 * w.x * w.z,
            y22 * (w.x * w.x - w.y * w.y)};
}

HarmonicStorage::HarmonicStorage(const ProbeGrid& grid, int order) : grid_(grid), order_(order) {}

std::size_t HarmonicStorage::bins() const {
    return (coefficients() + bins_at_once - 1) / bins_at_once * bins_at_once;
}

void HarmonicStorage::take_surfels(const SurfelCache& cache) {
    if (!even_.empty()) return;  // the rays stay
    const auto rays = static_cast<std::size_t>(cache.surfels().per_probe);
    even_.resize(probe_count(grid_) * coefficients(), 0.f);
    for (std::size_t i = 0; i < cache.surfels().size(); ++i) {
        const auto Y = harmonics(cache.surfels().direction[i]);
        for (std::size_t b = 0; b < coefficients(); ++b)
            even_[i / rays * coefficients() + b] += Y[b] * 4.f * pi / static_cast<float>(rays);
    }
}

void HarmonicStorage::store(std::span<const RayLight> rays, std::span<float> values) const {
    std::ranges::fill(values, 0.f);
    const float solid_angle = 4.f * pi / static_cast<float>(rays.size());
    for (const RayLight& ray : rays) {
        const auto Y = harmonics(ray.direction);
        for (std::size_t c = 0; c < 3; ++c) {
            const float L = ray.radiance[static_cast<int>(c)] * solid_angle;
            for (std::size_t b = 0; b < coefficients(); ++b)
                values[value_index(0, c, b, bins())] += L * Y[b];
        }
    }
}

Spectrum HarmonicStorage::irradiance(const ProbeNeighbours& around, std::span<const float> values,
                                     const glm::vec3& n) const {
    std::array<float, most_bins> response{};
    const auto Y = harmonics(n);
    for (std::size_t b = 0; b < coefficients(); ++b) response[b] = clamped_cosine[b] * Y[b];
    float even = 0.f;
    for (std::size_t k = 0; k < around.probe.size(); ++k) {
        const float* ones = &even_[around.probe[k] * coefficients()];
        for (std::size_t b = 0; b < coefficients(); ++b)
            even += around.weight[k] * response[b] * ones[b];
    }
    const auto [r, g, b] = look_up<float>(around, std::span(response).first(bins()), values);
    return Spectrum(r, g, b) * (pi / even);
}

}  // namespace plumbline::ddgi
