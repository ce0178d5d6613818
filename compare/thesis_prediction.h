// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "compare/least_squares.h"
#include "compare/observations.h"

namespace plumbline::compare {

/// What constants of `from` become in `to`, a factor each: the published formulas divide light by
/// squared distances, so that all but bounceAttenuation are areas. The unit of length of a scene is
/// taken to be the spacing of its probes.
Constants<double> unit_factors(const Observations& from, const Observations& to);

/// Which parameter of a fit each constant of each case is.
using ConstantPlaces = std::vector<Constants<std::size_t>>;

/// The fitted pixels of all cases, one after the other, as the thesis's model shows them;
/// derivatives are those of dual numbers through the renderer's own formulas.
class ThesisPrediction : public Prediction {
 public:
    /// `cases` must live on. A case's constants are its parameters times its
    /// `factors`.
    /// `fits_feedback`: multiBounceIntensity is free, so that its derivative is needed even at 0.
    ThesisPrediction(std::span<const Observations> cases, ConstantPlaces places,
                     std::vector<Constants<double>> factors, bool fits_feedback)
        : cases_(cases),
          places_(std::move(places)),
          factors_(std::move(factors)),
          fits_feedback_(fits_feedback) {}

    std::vector<double> predict(const std::vector<double>& parameters,
                                Jacobian* jacobian) const override;

    /// The constants of a case.
    Constants<double> constants(std::size_t k, const std::vector<double>& parameters) const;

 private:
    void add_derivatives(std::size_t k, const std::vector<double>& parameters,
                         std::vector<double>& values, Jacobian& jacobian) const;

    std::span<const Observations> cases_;
    ConstantPlaces places_;
    std::vector<Constants<double>> factors_;
    bool fits_feedback_;
};

}  // namespace plumbline::compare
