// SPDX-License-Identifier: Apache-2.0
#include "pathtracer/estimate.h"

#include <cmath>
#include <limits>

namespace plumbline::pathtracer {

void SampleSums::add(const Path& path, const glm::vec3& eye, const glm::vec3& forward) {
    direct += path.direct;
    bounce1 += path.bounce1;
    indirect += path.indirect;
    ++samples;
    if (!path.surface) return;
    albedo += path.surface->albedo;
    normal += path.surface->n();
    depth += glm::dot(path.surface->position - eye, forward);
    ++hits;
}

void SampleSums::add(const SampleSums& other) {
    direct += other.direct;
    bounce1 += other.bounce1;
    indirect += other.indirect;
    albedo += other.albedo;
    normal += other.normal;
    depth += other.depth;
    hits += other.hits;
    samples += other.samples;
}

void PixelEstimate::add_group(const SampleSums& group) {
    if (groups > 0) {
        const double before = sums.samples;
        const double added = group.samples;
        const double weight = before * added / (before + added);
        const glm::dvec3 radiance_step = group.radiance() / added - sums.radiance() / before;
        const glm::dvec3 indirect_step = group.indirect / added - sums.indirect / before;
        radiance_m2 += weight * radiance_step * radiance_step;
        indirect_m2 += weight * indirect_step * indirect_step;
    }
    sums.add(group);
    ++groups;
}

void PixelEstimate::join_groups() {
    radiance_m2 = indirect_m2 = glm::dvec3(0.);
    groups = sums.samples > 0 ? 1 : 0;
}

glm::dvec3 PixelEstimate::variance_of_mean(const glm::dvec3& m2) const {
    if (groups < 2) return glm::dvec3(std::numeric_limits<double>::quiet_NaN());
    return m2 / (double(groups - 1) * double(sums.samples));
}

double relmse_estimate(const PixelEstimate& pixel) {
    constexpr double epsilon = .01;  // of relMSE's definition
    const glm::dvec3 mean = pixel.sums.radiance() / double(pixel.sums.samples);
    const glm::dvec3 ratio = pixel.radiance_variance() / (mean * mean + epsilon);
    return (ratio.x + ratio.y + ratio.z) / 3.;
}

double relmse_estimate(std::span<const PixelEstimate> pixels) {
    double sum = 0.;
    std::size_t finite = 0;
    for (const PixelEstimate& pixel : pixels) {
        const double relmse = relmse_estimate(pixel);
        if (!std::isfinite(relmse)) continue;
        sum += relmse;
        ++finite;
    }
    return finite > 0 ? sum / double(finite) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace plumbline::pathtracer
