// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace plumbline::compare {

/// The one-dimensional kernels of FLIP, each symmetric around its middle; two-dimensional filters
/// are products of one along x and one along y.
struct FlipFilters {
    int spatial_radius;
    std::vector<float> achromatic;     ///< Y; sums to 1
    std::vector<float> red_green;      ///< Cx; sums to 1
    std::vector<float> blue_yellow_1;  ///< Cz is the sum of two products, 1 x 1 and 2 x 2:
    std::vector<float> blue_yellow_2;  ///< their sums squared add to 1

    int feature_radius;
    std::vector<float> gaussian;  ///< sums to 1
    std::vector<float> edge;      ///< first derivative: positive weights sum to 1, negative to -1
    std::vector<float> point;     ///< second derivative: the same
};

/// The kernels of [Andersson et al. 2020, sections 4.1 and 4.2].
FlipFilters make_flip_filters(double pixels_per_degree);

}  // namespace plumbline::compare
