// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace plumbline::compare {

/// The tone mappers among which HDR-FLIP lets choose [Andersson et al. 2021].
enum class ToneMapper {
    Aces,      ///< a filmic curve [Narkowicz 2015]: the default
    Hable,     ///< a filmic curve with a longer toe [Hable 2010]
    Reinhard,  ///< x / (1 + luminance), the same for all channels [Reinhard et al. 2002]
};

/// A tone mapper as (n2 x^2 + n1 x) / (d2 x^2 + d1 x + d0), as the authors write all three.
struct ToneCurve {
    std::string name;  ///< "ACES"
    double n2, n1, d2, d1, d0;
    bool of_luminance;  ///< the curve's gain at the luminance scales all channels

    /// The curve at x; n2/d2 at infinity.
    float operator()(float x) const;
    /// The x > 0 that the curve takes to y, 0 < y < 1: the positive root of
    /// (n2 - y d2) x^2 + (n1 - y d1) x - y d0 = 0.
    double inverse(double y) const;
};

const ToneCurve& tone_curve(ToneMapper mapper);

/// "aces", "hable" or "reinhard". Throws UsageError.
ToneMapper tone_mapper(const std::string& name);

}  // namespace plumbline::compare
