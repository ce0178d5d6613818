// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <span>

namespace plumbline::pathtracer {

/// Pearson's statistic of observed against expected counts, as a standard normal deviate
/// [Wilson and Hilferty 1931: the cube root of chi^2 / k is nearly normal].
inline double chi_square_z(std::span<const double> observed, std::span<const double> expected) {
    double statistic = 0.;
    for (std::size_t i = 0; i < observed.size(); ++i) {
        const double difference = observed[i] - expected[i];
        statistic += difference * difference / expected[i];
    }
    const double k = double(observed.size() - 1);
    const double spread = 2. / (9. * k);
    return (std::cbrt(statistic / k) - (1. - spread)) / std::sqrt(spread);
}

/// The deviate that `tests` independent standard normals all stay below in absolute value, except
/// with a probability of 1 in 1000 [Sidak 1967].
inline double sidak_limit(int tests) {
    const double each = 1. - std::pow(.999, 1. / tests);
    double z = 3.;
    // erfc(z / sqrt 2) is the probability of |deviate| > z, and falls steadily.
    while (std::erfc(z / std::sqrt(2.)) > each) z += .01;
    return z;
}

}  // namespace plumbline::pathtracer
