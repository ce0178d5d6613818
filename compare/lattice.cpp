// SPDX-License-Identifier: Apache-2.0
#include "compare/lattice.h"

#include <algorithm>
#include <cmath>

namespace plumbline::compare {

namespace {

constexpr double most_fitted_pixels = 20000;
/// Enough for a spread of standard errors within 6 %, few enough for tiles that are wider than what
/// neighbouring pixels share.
constexpr double tiles = 144;
/// Variances are kept at least at this share of their mean ...
constexpr double least_variance_share = 1e-3;
/// ... and standard deviations at this share of the values' root mean square.
constexpr double least_deviation_share = 1e-6;

std::size_t edge(double pixels, double count) {
    return std::size_t(std::ceil(std::sqrt(std::max(1.0, pixels / count))));
}

}  // namespace

Lattice::Lattice(int width, int height)
    : width_(std::size_t(width)),
      step_(edge(double(width) * height, most_fitted_pixels)),
      tile_edge_(edge(double(width) * height, tiles)) {}

bool Lattice::fitted(std::size_t pixel) const {
    return pixel % width_ % step_ == step_ / 2 && pixel / width_ % step_ == step_ / 2;
}

std::uint32_t Lattice::tile(std::size_t pixel) const {
    const std::size_t across = (width_ + tile_edge_ - 1) / tile_edge_;
    return std::uint32_t(pixel / width_ / tile_edge_ * across + pixel % width_ / tile_edge_);
}

void keep_variances_positive(const std::vector<double>& values, std::vector<double>& variance) {
    double mean_variance = 0, mean_square = 0;
    for (double v : variance) mean_variance += std::max(v, 0.0) / double(variance.size());
    for (double r : values) mean_square += r * r / double(values.size());
    const double least = std::max(least_variance_share * mean_variance,
                                  least_deviation_share * least_deviation_share * mean_square);
    for (double& v : variance) v = std::max(v, least);
}

}  // namespace plumbline::compare
