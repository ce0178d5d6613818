// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "compare/least_squares.h"
#include "compare/observations.h"

namespace plumbline::compare {

/// Which parameter of a fit each constant of each case is.
using ConstantPlaces = std::vector<Constants<std::size_t>>;

/// The fitted pixels of all cases, one after the other, as the thesis's model shows them;
/// derivatives are those of dual numbers through the renderer's own formulas.
class ThesisPrediction : public Prediction {
 public:
    /// `cases` must live on. `fits_feedback`: multiBounceIntensity is free, so that its derivative
    /// is needed even at 0.
    ThesisPrediction(std::span<const Observations> cases, ConstantPlaces places, bool fits_feedback)
        : cases_(cases), places_(std::move(places)), fits_feedback_(fits_feedback) {}

    std::vector<double> predict(const std::vector<double>& parameters,
                                Jacobian* jacobian) const override;

    /// The constants of a case.
    Constants<double> constants(std::size_t k, const std::vector<double>& parameters) const;

 private:
    void add_derivatives(std::size_t k, const std::vector<double>& parameters,
                         std::vector<double>& values, Jacobian& jacobian) const;

    std::span<const Observations> cases_;
    ConstantPlaces places_;
    bool fits_feedback_;
};

}  // namespace plumbline::compare
