// SPDX-License-Identifier: Apache-2.0
#include "ddgi/ray_gather.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace plumbline::ddgi {
namespace {

/// Rays are summed this many at a time, in fixed lanes: the order of the sums, and so every bit of
/// them, does not depend on how wide the machine's registers are.
constexpr std::size_t lanes = 8;
using Lanes = std::array<float, lanes>;

/// In cells: from here all rays of a probe look parallel from anywhere in the cells around it.
constexpr float far_in_cells = 1e4f;
/// The cosine of the flattest ray whose patch is not cut short.
constexpr float flattest = 1e-3f;

/// Sums in lanes; total() adds them up in one fixed order.
struct LaneSums {
    Lanes weight{}, red{}, green{}, blue{};

    RaySums total() const {
        RaySums sums;
        for (std::size_t i = 0; i < lanes; ++i) {
            sums.weight += weight[i];
            sums.radiance += Spectrum(red[i], green[i], blue[i]);
        }
        return sums;
    }
};

/// Adds t_i = weight_of(i) times the radiance of each ray.
template <typename Weight>
inline RaySums sum_rays(std::size_t rays, const float* radiance, const Weight& weight_of) {
    assert(rays % lanes == 0);
    const float* red = radiance;
    const float* green = radiance + rays;
    const float* blue = radiance + 2 * rays;
    LaneSums sums;
    for (std::size_t first = 0; first < rays; first += lanes) {
        for (std::size_t i = 0; i < lanes; ++i) {
            const float t = weight_of(first + i);
            sums.weight[i] += t;
            sums.red[i] += t * red[first + i];
            sums.green[i] += t * green[first + i];
            sums.blue[i] += t * blue[first + i];
        }
    }
    return sums.total();
}

}  // namespace

RayEnds::RayEnds(std::size_t probes, std::size_t rays, float spacing)
    : rays_(rays), far_(far_in_cells * spacing), values_(probes * value_count * rays) {}

void RayEnds::set(std::size_t probe, const glm::vec3& position, const Surfels& surfels) {
    float* values = &values_[probe * value_count * rays_];
    const auto put = [&](std::size_t ray, Value first, const glm::vec3& v) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            values[(first + axis) * rays_ + ray] = v[static_cast<int>(axis)];
        }
    };
    for (std::size_t ray = 0; ray < rays_; ++ray) {
        const std::size_t surfel = probe * rays_ + ray;
        const bool hit = surfels.hit(surfel);
        const glm::vec3& direction = surfels.direction[surfel];
        const float distance = hit ? surfels.distance[surfel] : far_;
        const glm::vec3 n = hit ? surfels.n[surfel] : -direction;
        put(ray, Dx, direction);
        put(ray, X, position + distance * direction);
        put(ray, Nx, n);
        values[PatchArea * rays_ + ray] =
            distance * distance / std::max(-glm::dot(n, direction), flattest);
    }
}

RaySums RayEnds::along_rays(std::size_t probe, const glm::vec3& n, const float* radiance) const {
    const float* dx = at(probe, Dx);
    const float* dy = at(probe, Dy);
    const float* dz = at(probe, Dz);
    return sum_rays(rays_, radiance, [&](std::size_t i) {
        return std::max(0.f, n.x * dx[i] + n.y * dy[i] + n.z * dz[i]);
    });
}

RaySums RayEnds::from_point(std::size_t probe, const glm::vec3& x, const glm::vec3& n,
                            const float* radiance) const {
    const float* ex = at(probe, X);
    const float* ey = at(probe, Y);
    const float* ez = at(probe, Z);
    const float* nx = at(probe, Nx);
    const float* ny = at(probe, Ny);
    const float* nz = at(probe, Nz);
    const float* area = at(probe, PatchArea);
    return sum_rays(rays_, radiance, [&](std::size_t i) {
        const float ux = ex[i] - x.x;
        const float uy = ey[i] - x.y;
        const float uz = ez[i] - x.z;
        // Not zero where x is the ray's end: the cosine, 0 / tiny, is then 0 and not NaN.
        const float d2 = std::max(std::numeric_limits<float>::min(), ux * ux + uy * uy + uz * uz);
        const float distance = std::sqrt(d2);
        const float cosine = std::max(0.f, n.x * ux + n.y * uy + n.z * uz) / distance;
        const float patch_cosine =
            std::max(0.f, -(nx[i] * ux + ny[i] * uy + nz[i] * uz)) / distance;
        const float ratio = area[i] * patch_cosine / d2;
        return cosine * std::min(most_magnified, std::max(1.f / most_magnified, ratio));
    });
}

}  // namespace plumbline::ddgi
