// SPDX-License-Identifier: Apache-2.0
#include "ddgi/ray_gather.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "ddgi/float8.h"
#include "scenes/wide.h"

namespace plumbline::ddgi {
namespace {

static_assert(rays_in_block == float8_lanes);

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

RayEnds::RayEnds(const Surfels& surfels, float spacing)
    : far_(far_in_cells * spacing),
      values_(surfels.probes(), static_cast<std::size_t>(surfels.per_probe)) {
    for (std::size_t i = 0; i < surfels.size(); ++i) {
        values_.put(i / values_.rays(), Dx, i % values_.rays(), surfels.direction[i]);
    }
}

void RayEnds::set(std::size_t probe, std::size_t ray, const glm::vec3& position,
                  const Surfels& surfels) {
    const std::size_t surfel = probe * values_.rays() + ray;
    const bool hit = surfels.hit(surfel);
    const glm::vec3& direction = surfels.direction[surfel];
    const float distance = hit ? surfels.place[surfel].distance : far_;
    const glm::vec3 n = hit ? surfels.place[surfel].n : -direction;
    values_.put(probe, X, ray, position + distance * direction);
    values_.put(probe, Nx, ray, n);
    values_.at(probe, PatchArea, ray) =
        distance * distance / std::max(-glm::dot(n, direction), flattest);
}

PLUMBLINE_WIDE [[gnu::flatten]] RaySums RayEnds::along_rays(std::size_t probe, const glm::vec3& n,
                                                            const float* radiance) const {
    const float* ends = values_.block(probe, 0, 0);
    return sum_rays(values_.rays(), radiance, [&](std::size_t i) {
        const auto value = [&](Value v) { return load_float8(ends + values_.further(i, v)); };
        return larger(Float8{}, n.x * value(Dx) + n.y * value(Dy) + n.z * value(Dz));
    });
}

PLUMBLINE_WIDE [[gnu::flatten]] RaySums RayEnds::from_point(std::size_t probe, const glm::vec3& x,
                                                            const glm::vec3& n,
                                                            const float* radiance) const {
    const float* ends = values_.block(probe, 0, 0);
    return sum_rays(values_.rays(), radiance, [&](std::size_t i) {
        const auto value = [&](Value v) { return load_float8(ends + values_.further(i, v)); };
        const Float8 ux = value(X) - x.x;
        const Float8 uy = value(Y) - x.y;
        const Float8 uz = value(Z) - x.z;
        // Not zero where x is the ray's end: the cosine, 0 / tiny, is then 0 and not NaN.
        const Float8 d2 =
            larger(same_float8(std::numeric_limits<float>::min()), ux * ux + uy * uy + uz * uz);
        const Float8 distance = square_root(d2);
        const Float8 cosine = larger(Float8{}, n.x * ux + n.y * uy + n.z * uz) / distance;
        const Float8 patch_cosine =
            larger(Float8{}, -(value(Nx) * ux + value(Ny) * uy + value(Nz) * uz)) / distance;
        const Float8 ratio = value(PatchArea) * patch_cosine / d2;
        return cosine * smaller(same_float8(most_magnified),
                                larger(same_float8(1.f / most_magnified), ratio));
    });
}

}  // namespace plumbline::ddgi
