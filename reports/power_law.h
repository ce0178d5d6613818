// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>

namespace plumbline::reports {

/// y = scale x^exponent, by least squares in logarithms.
struct PowerLaw {
    double exponent;
    /// 95 % interval of the exponent, taking the scatter of log y as independent and Gaussian
    /// (Student's t with n - 2 degrees of freedom). With two points it is all numbers.
    std::array<double, 2> exponent_ci95;
    double scale;
};

/// Fits positive values. None with fewer than two different x, or a value that is not above 0.
std::optional<PowerLaw> fit_power_law(std::span<const double> x, std::span<const double> y);

}  // namespace plumbline::reports
