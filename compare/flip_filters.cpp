// SPDX-License-Identifier: Apache-2.0
#include "compare/flip_filters.h"

#include <cmath>
#include <numbers>

namespace plumbline::compare {

namespace {

using std::numbers::pi;

/// Contrast sensitivity as a Gaussian in degrees; b sets its width [Andersson et al. 2020, table
/// 1].
struct Sensitivity {
    double a, b;
};
constexpr Sensitivity achromatic_csf{1, 0.0047};
constexpr Sensitivity red_green_csf{1, 0.0053};
constexpr Sensitivity blue_yellow_csf_1{34.1, 0.04};
constexpr Sensitivity blue_yellow_csf_2{13.5, 0.025};
/// Peak-to-trough distance of the eye's edge detector, degrees.
constexpr double feature_width = 0.082;
/// Where Gaussians are cut off, in standard deviations.
constexpr double cut_off = 3;

double sum_of(const std::vector<double>& weights) {
    double sum = 0;
    for (double weight : weights) sum += weight;
    return sum;
}

std::vector<float> scaled(const std::vector<double>& weights, double scale) {
    std::vector<float> result;
    for (double weight : weights) result.push_back(float(weight * scale));
    return result;
}

/// The factor along one axis of the two-dimensional a sqrt(pi/b) exp(-pi^2 (x^2 + y^2) / b).
std::vector<double> spatial_kernel(Sensitivity csf, int radius, double pixels_per_degree) {
    std::vector<double> weights;
    for (int i = -radius; i <= radius; ++i) {
        const double x = i / pixels_per_degree;
        weights.push_back(std::sqrt(csf.a * std::sqrt(pi / csf.b)) *
                          std::exp(-pi * pi * x * x / csf.b));
    }
    return weights;
}

/// Scales positive weights to the sum 1 and negative ones to -1.
std::vector<float> balanced(const std::vector<double>& weights) {
    double positive = 0, negative = 0;
    for (double weight : weights) (weight > 0 ? positive : negative) += std::abs(weight);
    std::vector<float> result;
    for (double weight : weights)
        result.push_back(float(weight / (weight > 0 ? positive : negative)));
    return result;
}

}  // namespace

FlipFilters make_flip_filters(double pixels_per_degree) {
    FlipFilters filters;
    const double widest = std::sqrt(blue_yellow_csf_1.b / (2 * pi * pi)) * pixels_per_degree;
    filters.spatial_radius = int(std::ceil(cut_off * widest));
    const auto kernel = [&](Sensitivity csf) {
        return spatial_kernel(csf, filters.spatial_radius, pixels_per_degree);
    };
    const auto normalised = [](const std::vector<double>& w) { return scaled(w, 1 / sum_of(w)); };
    filters.achromatic = normalised(kernel(achromatic_csf));
    filters.red_green = normalised(kernel(red_green_csf));
    const auto by_1 = kernel(blue_yellow_csf_1), by_2 = kernel(blue_yellow_csf_2);
    const double by_scale = 1 / std::hypot(sum_of(by_1), sum_of(by_2));
    filters.blue_yellow_1 = scaled(by_1, by_scale);
    filters.blue_yellow_2 = scaled(by_2, by_scale);

    const double sigma = 0.5 * feature_width * pixels_per_degree;
    filters.feature_radius = int(std::ceil(cut_off * sigma));
    std::vector<double> g, dg, ddg;
    for (int x = -filters.feature_radius; x <= filters.feature_radius; ++x) {
        g.push_back(std::exp(-x * x / (2 * sigma * sigma)));
        dg.push_back(-x * g.back());
        ddg.push_back((x * x / (sigma * sigma) - 1) * g.back());
    }
    filters.gaussian = normalised(g);
    filters.edge = balanced(dg);
    filters.point = balanced(ddg);
    return filters;
}

}  // namespace plumbline::compare
