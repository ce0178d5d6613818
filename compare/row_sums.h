// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tbb/parallel_for.h>

#include <array>
#include <cstddef>
#include <vector>

namespace plumbline::compare {

/// Sums N quantities over the rows of a picture in double precision.
///
/// `row_sum(y)` returns the N sums of row y and may run on any thread. The rows are then added
/// pairwise in a fixed order: the error grows with log(height) instead of height [Higham 1993],
/// and the result has the same bits at any thread count.
template <std::size_t N, typename RowSum>
std::array<double, N> sum_over_rows(int height, const RowSum& row_sum) {
    std::vector<std::array<double, N>> sums(static_cast<std::size_t>(height));
    tbb::parallel_for(0, height, [&](int y) { sums[std::size_t(y)] = row_sum(y); });
    for (std::size_t stride = 1; stride < sums.size(); stride *= 2)
        for (std::size_t i = 0; i + stride < sums.size(); i += 2 * stride)
            for (std::size_t k = 0; k < N; ++k) sums[i][k] += sums[i + stride][k];
    return sums.front();
}

}  // namespace plumbline::compare
