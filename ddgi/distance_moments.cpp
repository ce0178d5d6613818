// SPDX-License-Identifier: Apache-2.0
#include "ddgi/distance_moments.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>

namespace plumbline::ddgi {
namespace {

constexpr int map_side = 16;  // [Majercik et al. 2019]

/// In spacings, one and a half diagonals of a cell: beyond any point that looks the probe up, so
/// that what is farther need not spread the moments, nor a miss make them infinite.
const float farthest = 1.5f * std::sqrt(3.f);

/// Sums of weights below lose digits to those that are no normal floats, from 1e-38 on.
constexpr float least_weight = 1e-30f;

/// What the rays near a texel say of it, each with its weight.
struct Sums {
    float weight = 0.f;
    float distance = 0.f;
    float square = 0.f;
};

/// Sums with weights (cos / largest cos)^sharpness, which keep the ratios of cos^sharpness where
/// that underflows for every ray: the nearest ray weighs 1.
Sums relative_sums(const OctahedralTexels& texels, std::size_t texel, int sharpness,
                   std::span<const glm::vec3> directions, std::span<const float> distances) {
    const std::size_t lane = texel % OctahedralTexels::lanes;
    float largest = 0.f;
    for (const glm::vec3& w : directions)
        largest = std::max(largest, texels.lobes(texel - lane, w, 1)[lane]);
    assert(largest > 0.f);  // rays are all around: one is well within a right angle
    Sums sums;
    for (std::size_t r = 0; r < directions.size(); ++r) {
        const float lobe = texels.lobes(texel - lane, directions[r] / largest, sharpness)[lane];
        sums.weight += lobe;
        sums.distance += lobe * distances[r];
        sums.square += lobe * distances[r] * distances[r];
    }
    return sums;
}

}  // namespace

DistanceMoments::DistanceMoments(const ProbeGrid& grid, int sharpness)
    : grid_(grid),
      sharpness_(sharpness),
      texels_(map_side),
      moments_(probe_count(grid) * texels_.size(), Moments{0.f, 0.f}) {}

void DistanceMoments::take(const ProbeDistances& distances, const Surfels& surfels,
                           float back_shortening) {
    tbb::parallel_for(std::size_t{0}, std::size_t{probe_count(grid_)}, [&](std::size_t probe) {
        if (distances.changed(probe)) take_probe(distances, surfels, back_shortening, 0.f, probe);
    });
}

void DistanceMoments::blend(const ProbeDistances& distances, const Surfels& surfels,
                            float back_shortening, float kept) {
    tbb::parallel_for(std::size_t{0}, std::size_t{probe_count(grid_)}, [&](std::size_t probe) {
        take_probe(distances, surfels, back_shortening, kept, probe);
    });
}

void DistanceMoments::take_probe(const ProbeDistances& distances, const Surfels& surfels,
                                 float back_shortening, float kept, std::size_t probe) {
    constexpr std::size_t lanes = OctahedralTexels::lanes;
    using Lanes = OctahedralTexels::Lanes;
    const auto rays = static_cast<std::size_t>(surfels.per_probe);
    const auto directions = std::span(surfels.direction).subspan(probe * rays, rays);
    std::vector<float> distance(rays);
    for (std::size_t r = 0; r < rays; ++r) {
        const std::size_t i = probe * rays + r;
        const float shortening = distances.back(i) ? back_shortening : 1.f;
        distance[r] = std::min(shortening * distances.distance(i) / grid_.spacing, farthest);
    }
    for (std::size_t first = 0; first < texels_.size(); first += lanes) {
        Lanes weight{}, sum{}, sum_of_squares{};
        for (std::size_t r = 0; r < rays; ++r) {
            const Lanes lobe = texels_.lobes(first, directions[r], sharpness_);
            for (std::size_t i = 0; i < lanes; ++i) {
                weight[i] += lobe[i];
                sum[i] += lobe[i] * distance[r];
                sum_of_squares[i] += lobe[i] * distance[r] * distance[r];
            }
        }
        for (std::size_t i = 0; i < lanes; ++i) {
            Sums sums{weight[i], sum[i], sum_of_squares[i]};
            if (sums.weight < least_weight)
                sums = relative_sums(texels_, first + i, sharpness_, directions, distance);
            Moments& moments = moments_[probe * texels_.size() + first + i];
            moments.mean = kept * moments.mean + (1.f - kept) * sums.distance / sums.weight;
            moments.mean_square =
                kept * moments.mean_square + (1.f - kept) * sums.square / sums.weight;
        }
    }
}

float DistanceMoments::visibility(std::size_t probe, const glm::vec3& x) const {
    const glm::vec3 way =
        (x - probe_position(grid_, static_cast<std::uint32_t>(probe))) / grid_.spacing;
    const float r = glm::length(way);
    if (r == 0.f) return 1.f;
    const TexelBlend blend = texels_.at(way / r);
    Moments mean{0.f, 0.f};
    for (std::size_t k = 0; k < blend.texel.size(); ++k) {
        const Moments& moments = moments_[probe * texels_.size() + blend.texel[k]];
        mean.mean += blend.weight[k] * moments.mean;
        mean.mean_square += blend.weight[k] * moments.mean_square;
    }
    if (r <= mean.mean) return 1.f;
    // Cancellation: a variance of 0 may come out as 1e-6 of the square, of either sign.
    const float variance = std::abs(mean.mean * mean.mean - mean.mean_square);
    const float beyond = r - mean.mean;
    return variance / (variance + beyond * beyond);
}

}  // namespace plumbline::ddgi
