// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "compare/least_squares.h"

namespace plumbline::compare {

/// The covariance of the parameters `free`, in their own units, over 500 samples of the tiles,
/// drawn with replacement by a fixed seed. Each sample is answered by one step of Gauss and Newton
/// from the solution, along the columns of `directions` only (rows: free parameters) [Davidson and
/// MacKinnon 1999].
Eigen::MatrixXd tile_bootstrap(const Whitened& whitened, const Observed& observed,
                               const std::vector<std::size_t>& free,
                               const Eigen::MatrixXd& directions);

}  // namespace plumbline::compare
