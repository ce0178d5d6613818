// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tbb/parallel_for.h>

#include <array>
#include <cstddef>
#include <vector>

namespace plumbline::compare {

/// Merges what `row_sum(y)` returns for the rows of a picture, any type with add(const Sum&).
///
/// Rows may run on any thread. They are then added pairwise in a fixed order: the error grows with
/// log(height) instead of height [Higham 1993], and the result has the same bits at any thread
/// count.
template <typename Sum, typename RowSum>
Sum merge_rows(int height, const RowSum& row_sum) {
    std::vector<Sum> sums(static_cast<std::size_t>(height));
    tbb::parallel_for(0, height, [&](int y) { sums[std::size_t(y)] = row_sum(y); });
    for (std::size_t stride = 1; stride < sums.size(); stride *= 2)
        for (std::size_t i = 0; i + stride < sums.size(); i += 2 * stride)
            sums[i].add(sums[i + stride]);
    return std::move(sums.front());
}

/// The same for N quantities in double precision.
template <std::size_t N, typename RowSum>
std::array<double, N> sum_over_rows(int height, const RowSum& row_sum) {
    struct Sums {
        std::array<double, N> values;
        void add(const Sums& other) {
            for (std::size_t k = 0; k < N; ++k) values[k] += other.values[k];
        }
    };
    return merge_rows<Sums>(height, [&](int y) { return Sums{row_sum(y)}; }).values;
}

}  // namespace plumbline::compare
