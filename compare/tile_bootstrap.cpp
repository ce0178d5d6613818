// SPDX-License-Identifier: Apache-2.0
#include "compare/tile_bootstrap.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <random>

namespace plumbline::compare {

namespace {

constexpr int samples = 500;
constexpr unsigned seed = 1;

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// J^T J and J^T r of one tile, along the directions.
struct TileSums {
    MatrixXd normal;
    VectorXd gradient;
};

std::vector<TileSums> sums_by_tile(const Whitened& whitened, const Observed& observed,
                                   const std::vector<std::size_t>& free,
                                   const MatrixXd& directions) {
    const std::size_t tiles =
        std::size_t(*std::max_element(observed.tile.begin(), observed.tile.end())) + 1;
    const Index n = directions.cols();
    std::vector<TileSums> sums(tiles, {MatrixXd::Zero(n, n), VectorXd::Zero(n)});
    VectorXd slope(Index(free.size()));
    for (std::size_t i = 0; i < observed.tile.size(); ++i) {
        for (std::size_t k = 0; k < free.size(); ++k)
            slope[Index(k)] = whitened.jacobian(Index(i), Index(free[k]));
        const VectorXd along = directions.transpose() * slope;
        TileSums& tile = sums[observed.tile[i]];
        tile.normal += along * along.transpose();
        tile.gradient += along * whitened.residuals[i];
    }
    return sums;
}

}  // namespace

MatrixXd tile_bootstrap(const Whitened& whitened, const Observed& observed,
                        const std::vector<std::size_t>& free, const MatrixXd& directions) {
    const std::vector<TileSums> tiles = sums_by_tile(whitened, observed, free, directions);
    std::mt19937 random(seed);
    std::uniform_int_distribution<std::size_t> any(0, tiles.size() - 1);
    const Index n = directions.cols();
    MatrixXd steps(n, samples);
    for (Index sample = 0; sample < samples; ++sample) {
        MatrixXd normal = MatrixXd::Zero(n, n);
        VectorXd gradient = VectorXd::Zero(n);
        for (std::size_t k = 0; k < tiles.size(); ++k) {
            const TileSums& tile = tiles[any(random)];
            normal += tile.normal;
            gradient += tile.gradient;
        }
        steps.col(sample) = -normal.ldlt().solve(gradient);
    }
    const MatrixXd centred = steps.colwise() - steps.rowwise().mean();
    return directions * (centred * centred.transpose() / (samples - 1)) * directions.transpose();
}

}  // namespace plumbline::compare
