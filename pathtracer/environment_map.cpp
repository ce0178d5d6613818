// SPDX-License-Identifier: Apache-2.0
#include "pathtracer/environment_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace plumbline::pathtracer {
namespace {

using std::numbers::pi;

/// Relative luminance of linear Rec.709.
double luminance(const Spectrum& L) {
    return .2126 * double(L.r) + .7152 * double(L.g) + .0722 * double(L.b);
}

/// An index chosen by a number `u` of [0,1) from cumulative weights that begin with 0, and where
/// `u` lies in its share, in [0,1).
std::pair<std::size_t, double> choose(std::span<const double> cumulative, double u) {
    const double at = u * cumulative.back();
    const auto above = std::upper_bound(cumulative.begin() + 1, cumulative.end() - 1, at);
    const auto index = static_cast<std::size_t>(above - cumulative.begin()) - 1;
    const double share = cumulative[index + 1] - cumulative[index];
    constexpr double last = 0x1.fffffffffffffp-1;
    const double within = share > 0. ? (at - cumulative[index]) / share : 0.;
    return {index, std::clamp(within, 0., last)};
}

}  // namespace

EnvironmentMap::EnvironmentMap(const World& world)
    : world_(world),
      panorama_(*world.environment_image->panorama),
      width_(static_cast<std::size_t>(panorama_.width)),
      height_(static_cast<std::size_t>(panorama_.height)),
      rows_(height_ + 1, 0.),
      columns_(height_ * (width_ + 1), 0.) {
    for (std::size_t row = 0; row < height_; ++row) {
        double* cumulative = &columns_[row * (width_ + 1)];
        for (std::size_t column = 0; column < width_; ++column) {
            const Spectrum L = world.environment * panorama_.radiance[pixel(row, column)];
            cumulative[column + 1] = cumulative[column] + luminance(L) * solid_angle(row);
        }
        rows_[row + 1] = rows_[row] + cumulative[width_];
    }
}

double EnvironmentMap::solid_angle(std::size_t row) const {
    const auto height = static_cast<double>(height_);
    const double upper = std::cos(pi * static_cast<double>(row) / height);
    const double lower = std::cos(pi * static_cast<double>(row + 1) / height);
    return 2. * pi / static_cast<double>(width_) * (upper - lower);
}

EnvironmentMap::Sample EnvironmentMap::sample(const glm::vec2& u) const {
    if (rows_.back() == 0.) return {{0.f, 1.f, 0.f}, Spectrum(0.f), 0.f};
    const auto [row, down] = choose(rows_, double(u.y));
    const std::span<const double> cumulative(&columns_[row * (width_ + 1)], width_ + 1);
    const auto [column, right] = choose(cumulative, double(u.x));
    // Even by solid angle within the pixel: even in the cosine of the angle from the top.
    const auto height = static_cast<double>(height_);
    const double upper = std::cos(pi * static_cast<double>(row) / height);
    const double lower = std::cos(pi * static_cast<double>(row + 1) / height);
    const double theta = std::acos(std::clamp(upper + down * (lower - upper), -1., 1.));
    const glm::dvec2 place((static_cast<double>(column) + right) / static_cast<double>(width_),
                           theta / pi);
    const Spectrum L = world_.environment * panorama_.radiance[pixel(row, column)];
    const glm::vec3 wi =
        EnvironmentImage::turned(Panorama::direction(place), world_.environment_image->rotation);
    return {wi, L, static_cast<float>(luminance(L) / rows_.back())};
}

float EnvironmentMap::pdf(const glm::vec3& wi) const {
    if (rows_.back() == 0.) return 0.f;
    return static_cast<float>(luminance(environment_radiance(world_, wi)) / rows_.back());
}

}  // namespace plumbline::pathtracer
