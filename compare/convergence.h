// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ceres/jet.h>

#include <array>
#include <cstddef>
#include <span>

namespace plumbline::compare {

/// A number's value.
inline std::array<double, 1> parts_of(double number) { return {number}; }
/// A dual number's value and derivatives.
template <int N>
std::array<double, N + 1> parts_of(const ceres::Jet<double, N>& number) {
    std::array<double, N + 1> parts{number.a};
    for (int k = 0; k < N; ++k) parts[std::size_t(k) + 1] = number.v[k];
    return parts;
}

/// Tells when an iteration has settled, derivatives included: they settle later than values, and
/// a fit stopped by the values alone would follow wrong slopes.
class Convergence {
 public:
    /// Whether no part changed by more than 1e-10 of the largest of its kind. Throws FitError if
    /// values are not finite or the iterations do not end.
    template <typename T>
    bool reached(std::span<const T> previous, std::span<const T> next) {
        // Looking costs about as much as an update.
        if (++iterations_ % iterations_per_look != 0) return false;
        constexpr std::size_t count = std::tuple_size_v<decltype(parts_of(T()))>;
        std::array<double, count> change{}, size{};
        for (std::size_t i = 0; i < next.size(); ++i) {
            const auto before = parts_of(previous[i]), after = parts_of(next[i]);
            for (std::size_t k = 0; k < count; ++k) {
                change[k] = larger(change[k], after[k] - before[k]);
                size[k] = larger(size[k], after[k]);
            }
        }
        return settled(change, size);
    }

 private:
    static constexpr int iterations_per_look = 8;
    /// max(a, |b|), or not a number if b is not.
    static double larger(double a, double b);
    bool settled(std::span<const double> change, std::span<const double> size) const;

    int iterations_ = 0;
};

}  // namespace plumbline::compare
