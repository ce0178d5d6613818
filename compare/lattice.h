// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace plumbline::compare {

/// Which pixels of a picture are fitted: at most about 20,000, evenly; and in which of about 144
/// square tiles each lies.
class Lattice {
 public:
    Lattice(int width, int height);
    bool fitted(std::size_t pixel) const;
    std::uint32_t tile(std::size_t pixel) const;

 private:
    std::size_t width_, step_, tile_edge_;
};

/// Raises variances to 1e-3 of their mean and to (1e-6 of the values' root mean square)^2: a pixel
/// that happened to see no light has an estimated variance of zero and would divide by it.
void keep_variances_positive(const std::vector<double>& values, std::vector<double>& variance);

}  // namespace plumbline::compare
