// SPDX-License-Identifier: Apache-2.0
#include "ddgi/ray_gather.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "ddgi/float8.h"
#include "scenes/wide.h"

namespace plumbline::ddgi {
namespace {

/// In cells: from here all rays of a probe look parallel from anywhere in the cells around it.
constexpr float far_in_cells = 1e4f;
/// The cosine of the flattest ray whose patch is not cut short.
constexpr float flattest = 1e-3f;

/// Adds t_i = weight_of(i) times the radiance of each ray, float8_lanes of them from i on at a
/// time: in fixed lanes, so that no bit of the sums depends on the machine's registers.
template <typename Weight>
inline RaySums sum_rays(std::size_t rays, const float* radiance, const Weight& weight_of) {
    assert(rays % float8_lanes == 0);
    Float8 weight{}, red{}, green{}, blue{};
    for (std::size_t i = 0; i < rays; i += float8_lanes) {
        const Float8 t = weight_of(i);
        weight += t;
        red += t * load_float8(radiance + i);
        green += t * load_float8(radiance + rays + i);
        blue += t * load_float8(radiance + 2 * rays + i);
    }
    return {Spectrum(sum_of(red), sum_of(green), sum_of(blue)), sum_of(weight)};
}

}  // namespace

RayEnds::RayEnds(std::size_t probes, std::size_t rays, float spacing)
    : rays_(rays), far_(far_in_cells * spacing), values_(probes * value_count * rays) {}

void RayEnds::set(std::size_t probe, std::size_t ray, const glm::vec3& position,
                  const Surfels& surfels) {
    float* values = &values_[probe * value_count * rays_];
    const auto put = [&](Value first, const glm::vec3& v) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            values[(first + axis) * rays_ + ray] = v[static_cast<int>(axis)];
        }
    };
    const std::size_t surfel = probe * rays_ + ray;
    const bool hit = surfels.hit(surfel);
    const glm::vec3& direction = surfels.direction[surfel];
    const float distance = hit ? surfels.distance[surfel] : far_;
    const glm::vec3 n = hit ? surfels.n[surfel] : -direction;
    put(Dx, direction);
    put(X, position + distance * direction);
    put(Nx, n);
    values[PatchArea * rays_ + ray] =
        distance * distance / std::max(-glm::dot(n, direction), flattest);
}

PLUMBLINE_WIDE [[gnu::flatten]] RaySums RayEnds::along_rays(std::size_t probe, const glm::vec3& n,
                                                            const float* radiance) const {
    const float* dx = at(probe, Dx);
    const float* dy = at(probe, Dy);
    const float* dz = at(probe, Dz);
    return sum_rays(rays_, radiance, [&](std::size_t i) {
        return larger(Float8{}, n.x * load_float8(dx + i) + n.y * load_float8(dy + i) +
                                    n.z * load_float8(dz + i));
    });
}

PLUMBLINE_WIDE [[gnu::flatten]] RaySums RayEnds::from_point(std::size_t probe, const glm::vec3& x,
                                                            const glm::vec3& n,
                                                            const float* radiance) const {
    const float* ex = at(probe, X);
    const float* ey = at(probe, Y);
    const float* ez = at(probe, Z);
    const float* nx = at(probe, Nx);
    const float* ny = at(probe, Ny);
    const float* nz = at(probe, Nz);
    const float* area = at(probe, PatchArea);
    return sum_rays(rays_, radiance, [&](std::size_t i) {
        const Float8 ux = load_float8(ex + i) - x.x;
        const Float8 uy = load_float8(ey + i) - x.y;
        const Float8 uz = load_float8(ez + i) - x.z;
        // Not zero where x is the ray's end: the cosine, 0 / tiny, is then 0 and not NaN.
        const Float8 d2 =
            larger(same_float8(std::numeric_limits<float>::min()), ux * ux + uy * uy + uz * uz);
        const Float8 distance = square_root(d2);
        const Float8 cosine = larger(Float8{}, n.x * ux + n.y * uy + n.z * uz) / distance;
        const Float8 patch_cosine =
            larger(Float8{}, -(load_float8(nx + i) * ux + load_float8(ny + i) * uy +
                               load_float8(nz + i) * uz)) /
            distance;
        const Float8 ratio = load_float8(area + i) * patch_cosine / d2;
        return cosine * smaller(same_float8(most_magnified),
                                larger(same_float8(1.f / most_magnified), ratio));
    });
}

}  // namespace plumbline::ddgi
