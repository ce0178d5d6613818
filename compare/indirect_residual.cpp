// SPDX-License-Identifier: Apache-2.0
#include "compare/indirect_residual.h"

#include <ceres/autodiff_cost_function.h>

namespace plumbline::compare {

namespace {

constexpr int constant_count = int(constant_names.size());
using Jet = ceres::Jet<double, constant_count>;

}  // namespace

ceres::CostFunction* IndirectResidual::cost_function(const Observations& observations,
                                                     double misfit_variance) {
    return new ceres::AutoDiffCostFunction<IndirectResidual, ceres::DYNAMIC, constant_count>(
        new IndirectResidual{observations, misfit_variance}, int(observations.radiance().size()));
}

std::vector<double> model_errors(const Observations& observations,
                                 const Constants<double>& constants) {
    std::vector<double> errors =
        observations.picture().indirect<double>(constants, observations.pixels());
    for (std::size_t i = 0; i < errors.size(); ++i) errors[i] -= observations.radiance()[i];
    return errors;
}

NormalMatrix normal_matrix(const Observations& observations, double misfit_variance,
                           const Constants<double>& constants) {
    std::array<Jet, constant_names.size()> jets;
    for (int k = 0; k < constant_count; ++k)
        jets[std::size_t(k)] = Jet(constants[std::size_t(k)], k);
    std::vector<Jet> residuals(observations.radiance().size());
    IndirectResidual{observations, misfit_variance}(jets.data(), residuals.data());
    NormalMatrix normal = NormalMatrix::Zero();
    for (const Jet& residual : residuals) normal += residual.v * residual.v.transpose();
    return normal;
}

}  // namespace plumbline::compare
