// SPDX-License-Identifier: Apache-2.0
#include "compare/tone_mapper.h"

#include <array>
#include <cmath>

#include "scenes/errors.h"

namespace plumbline::compare {

namespace {

/// The ACES curve's author built in an exposure, which is cancelled.
constexpr double pre_exposure = 0.6;

/// In the order of ToneMapper.
const std::array<ToneCurve, 3> curves{{
    {"ACES", pre_exposure* pre_exposure * 2.51, pre_exposure * 0.03,
     pre_exposure* pre_exposure * 2.43, pre_exposure * 0.59, 0.14, false},
    {"Hable", 0.231683, 0.013791, 0.18, 0.3, 0.018, false},
    {"Reinhard", 0, 1, 0, 1, 1, true},
}};

}  // namespace

float ToneCurve::operator()(float x) const {
    const auto [a, b, c, d, e] = std::array{float(n2), float(n1), float(d2), float(d1), float(d0)};
    // Divided by x^2 beyond 1, lest very bright pixels become infinity over infinity.
    if (std::abs(x) > 1.f) return (a + b / x) / (c + d / x + e / x / x);
    return (a * x * x + b * x) / (c * x * x + d * x + e);
}

double ToneCurve::inverse(double y) const {
    const double a = n2 - y * d2, half_b = 0.5 * (n1 - y * d1), c = -y * d0;
    if (a == 0) return -c / (2 * half_b);
    return (-half_b + std::sqrt(half_b * half_b - a * c)) / a;
}

const ToneCurve& tone_curve(ToneMapper mapper) { return curves[std::size_t(mapper)]; }

ToneMapper tone_mapper(const std::string& name) {
    if (name == "aces") return ToneMapper::Aces;
    if (name == "hable") return ToneMapper::Hable;
    if (name == "reinhard") return ToneMapper::Reinhard;
    throw UsageError("--tone-mapper", "'" + name + "' is none", "aces, hable or reinhard");
}

}  // namespace plumbline::compare
