// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ceres/cost_function.h>

#include "compare/identifiability.h"
#include "compare/observations.h"

namespace plumbline::compare {

/// Residuals r = (E_model - E_reference) / sqrt(s^2 + tau^2), dimensionless: three a fitted pixel.
///
/// With independent Gaussian errors sum r^2 is chi-square distributed, so its minimum is the
/// maximum-likelihood fit.
struct IndirectResidual {
    const Observations& observations;
    double misfit_variance;  ///< tau^2

    template <typename T>
    bool operator()(const T* constants, T* residuals) const;

    /// With derivatives by dual numbers; the caller owns it. `observations` must live on.
    static ceres::CostFunction* cost_function(const Observations& observations,
                                              double misfit_variance);
};

/// E_model - E_reference of the fitted pixels and channels.
std::vector<double> model_errors(const Observations& observations,
                                 const Constants<double>& constants);

/// J^T J of the residuals at these constants, none of them held.
NormalMatrix normal_matrix(const Observations& observations, double misfit_variance,
                           const Constants<double>& constants);

template <typename T>
bool IndirectResidual::operator()(const T* constants, T* residuals) const {
    const std::vector<T> model = observations.picture().indirect<T>(
        {constants[0], constants[1], constants[2]}, observations.pixels());
    for (std::size_t i = 0; i < model.size(); ++i) {
        const double deviation = std::sqrt(observations.variance()[i] + misfit_variance);
        residuals[i] = (model[i] - observations.radiance()[i]) / deviation;
    }
    return true;
}

}  // namespace plumbline::compare
