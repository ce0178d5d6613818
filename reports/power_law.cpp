// SPDX-License-Identifier: Apache-2.0
#include "reports/power_law.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

namespace plumbline::reports {

namespace {

/// The 97.5 % point of Student's t for 1 to 10 degrees of freedom; from there on it changes by less
/// than a seventh, and the last is kept, which makes intervals wider, never narrower.
constexpr std::array t_975 = {12.706, 4.303, 3.182, 2.776, 2.571,
                              2.447,  2.365, 2.306, 2.262, 2.228};

double mean(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

std::vector<double> logarithms(std::span<const double> values) {
    std::vector<double> logs;
    for (const double value : values) logs.push_back(std::log(value));
    return logs;
}

/// Half the width of the interval of a slope that leaves `residual`, a sum of squares.
double half_width(double residual, double spread, std::size_t points) {
    if (points < 3) return std::numeric_limits<double>::infinity();
    const std::size_t freedom = points - 2;
    const double variance = residual / static_cast<double>(freedom) / spread;
    return t_975[std::min(freedom, t_975.size()) - 1] * std::sqrt(variance);
}

}  // namespace

std::optional<PowerLaw> fit_power_law(std::span<const double> x, std::span<const double> y) {
    assert(x.size() == y.size());
    const auto positive = [](double value) { return value > 0 && std::isfinite(value); };
    if (x.size() < 2 || !std::ranges::all_of(x, positive) || !std::ranges::all_of(y, positive))
        return std::nullopt;
    const std::vector<double> u = logarithms(x);
    const std::vector<double> v = logarithms(y);
    const double u_mean = mean(u);
    const double v_mean = mean(v);
    double spread = 0;
    double product = 0;
    for (std::size_t i = 0; i < u.size(); ++i) {
        spread += (u[i] - u_mean) * (u[i] - u_mean);
        product += (u[i] - u_mean) * (v[i] - v_mean);
    }
    if (spread == 0) return std::nullopt;
    const double slope = product / spread;
    double residual = 0;
    for (std::size_t i = 0; i < u.size(); ++i) {
        const double off = v[i] - v_mean - slope * (u[i] - u_mean);
        residual += off * off;
    }
    const double half = half_width(residual, spread, u.size());
    return PowerLaw{slope, {slope - half, slope + half}, std::exp(v_mean - slope * u_mean)};
}

}  // namespace plumbline::reports
