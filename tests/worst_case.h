// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <sstream>
#include <string>

namespace plumbline {

/// 2^-24: the largest relative error of one rounding to float.
inline constexpr double float_rounding = 0x1p-24;

/// Over many inputs, the one whose error is the largest share of what it may be.
class WorstCase {
 public:
    /// `error` of a float result, the bound derived for it, and the input that gave it.
    template <typename... Input>
    void add(double error, double bound, const Input&... input) {
        const double share = std::abs(error) / bound;
        if (share <= share_ || std::isnan(share_)) return;  // NaN is the worst of all, and stays
        share_ = share;
        std::ostringstream text;
        text.precision(9);
        ((text << input << ' '), ...);
        input_ = text.str();
    }
    /// Largest error over its bound; NaN if one was.
    double share() const { return share_; }
    const std::string& input() const { return input_; }

 private:
    double share_ = 0.;
    std::string input_ = "none";
};

}  // namespace plumbline
