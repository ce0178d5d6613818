// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>

#include "pathtracer/path.h"

namespace plumbline::pathtracer {

/// Sums over samples of one pixel. In double, where a sum of 2^24 floats keeps all their digits.
struct SampleSums {
    glm::dvec3 direct{0.}, bounce1{0.}, indirect{0.};  ///< over samples
    glm::dvec3 albedo{0.}, normal{0.};                 ///< over the samples that hit a surface
    double depth = 0.;                                 ///< over these too, along the view axis
    std::uint32_t hits = 0;
    std::uint32_t samples = 0;

    /// Adds a path from a camera at `eye` that looks along the unit vector `forward`.
    void add(const Path& path, const glm::vec3& eye, const glm::vec3& forward);
    void add(const SampleSums& other);

    glm::dvec3 radiance() const { return direct + indirect; }
};

/// What is known of one pixel: sums over its samples, and how far groups of them lie apart.
///
/// A group is a set of n_i samples that is independent of the others: a batch of the sampler. With
/// x_i the means of k groups, N samples in all and x the mean of all, sum n_i (x_i - x)^2 / (k-1)
/// estimates N times the variance of x.
///
/// A single sample may stand as a group too, before two batches are there. Samples of one batch
/// are stratified against each other, so that their mean varies less than their spread says: that
/// estimate is conservative, by 2 for a batch of 16 of the library's Cornell Box. No estimate from
/// one batch can be unbiased, since only independent batches tell how their means vary.
struct PixelEstimate {
    SampleSums sums;
    glm::dvec3 radiance_m2{0.}, indirect_m2{0.};  ///< sum n_i (x_i - x)^2
    std::uint32_t groups = 0;

    /// Adds a group, independent of those before [West 1979, weighted update].
    void add_group(const SampleSums& group);

    /// Counts all samples so far as one group.
    void join_groups();

    /// Variance of the mean; NaN with fewer than two groups.
    glm::dvec3 radiance_variance() const { return variance_of_mean(radiance_m2); }
    glm::dvec3 indirect_variance() const { return variance_of_mean(indirect_m2); }

 private:
    glm::dvec3 variance_of_mean(const glm::dvec3& m2) const;
};

/// Expected relMSE of a pixel's radiance against the truth: the mean over channels of variance of
/// the mean / (mean^2 + 0.01). Not finite with fewer than two groups, or if the pixel is not.
double relmse_estimate(const PixelEstimate& pixel);

/// Expected relMSE of the radiance layer: the mean over its pixels, those that are not finite left
/// out. NaN with fewer than two groups a pixel. The same bits whatever the threads.
double relmse_estimate(std::span<const PixelEstimate> pixels);

}  // namespace plumbline::pathtracer
